#include "rectilin/corpus/file_kind.h"

#include <stdexcept>

namespace rectilin::corpus {
namespace {

std::int64_t pragma(Database& database, const std::string& name) {
  Statement statement(database, "PRAGMA " + name);
  return statement.step() ? statement.integer(0) : 0;
}

}  // namespace

bool is_empty(Database& database) {
  Statement tables(database, "SELECT count(*) FROM sqlite_master");
  tables.step();
  return tables.integer(0) == 0;
}

void make_tables(Database& database, const FileKind& kind, const Facts& facts) {
  if (!is_empty(database)) return;
  Transaction transaction(database);
  database.execute(kind.tables);
  database.execute("PRAGMA application_id = " + std::to_string(kind.application) +
                   "; PRAGMA user_version = " + std::to_string(kind.version));
  for (const auto& [key, value] : facts) set_fact(database, key, value);
  transaction.commit();
}

void check_kind(Database& database, const FileKind& kind) {
  if (pragma(database, "application_id") != kind.application)
    throw std::runtime_error(database.name() + ": not " + kind.name);
  if (pragma(database, "user_version") != kind.version)
    throw std::runtime_error(database.name() + ": " + kind.name + " of another version of the program");
}

bool is_of_kind(const std::filesystem::path& file, const FileKind& kind) {
  try {
    Database database(file, Database::Mode::kRead);
    return pragma(database, "application_id") == kind.application;
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::string fact(Database& database, std::string_view key) {
  Statement statement(database, "SELECT value FROM facts WHERE key = ?1");
  return statement.bind(1, key).step() ? std::string(statement.text(0)) : std::string();
}

void set_fact(Database& database, std::string_view key, std::string_view value) {
  Statement(database, "INSERT OR REPLACE INTO facts(key, value) VALUES(?1, ?2)").bind(1, key).bind(2, value).run();
}

}  // namespace rectilin::corpus
