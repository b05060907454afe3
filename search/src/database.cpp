#include "rectilin/search/database.h"

#include <chrono>
#include <stdexcept>

#include "database_access.h"
#include "rectilin/base/version.h"
#include "rectilin/corpus/writer_lock.h"
#include "rectilin/retrieval/best.h"
#include "rectilin/retrieval/features.h"

namespace rectilin::search {
namespace {

namespace fs = std::filesystem;
using corpus::Statement;
using Mode = corpus::Database::Mode;

constexpr const char* kSearchTables = R"(
CREATE TABLE members(
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, source TEXT NOT NULL, digest TEXT NOT NULL, status INTEGER NOT NULL,
  faces INTEGER NOT NULL, rectilinearity REAL, size REAL, error TEXT NOT NULL, seconds REAL);
CREATE TABLE signatures(
  member INTEGER NOT NULL, part INTEGER NOT NULL, bytes BLOB NOT NULL, PRIMARY KEY(member, part));
CREATE TABLE facts(key TEXT PRIMARY KEY NOT NULL, value TEXT NOT NULL) WITHOUT ROWID;
)";

constexpr corpus::FileKind kSearchFile = {0x7265736, 2, kSearchTables, "a database of shapes"};

constexpr const char* kColumns = "id, name, source, digest, status, faces, rectilinearity, size, error, seconds";

Member read_member(const Statement& s) {
  Member m;
  m.id = s.integer(0);
  m.name = s.text(1);
  m.source = s.text(2);
  m.digest = s.text(3);
  m.status = static_cast<MemberStatus>(s.integer(4));
  m.faces = static_cast<std::size_t>(s.integer(5));
  m.rectilinearity = s.real(6);
  m.size = s.real(7);
  m.error = s.text(8);
  m.seconds = s.real(9);
  return m;
}

/// The descriptor with all settings of its terms: what signatures depend on.
std::string all_settings(const std::string& descriptor) {
  std::string text;
  for (const retrieval::Term& term : retrieval::parse_composite(descriptor))
    text += (text.empty() ? "" : "+") + retrieval::full_spec(term.spec);
  return text;
}

}  // namespace

struct Database::Implementation {
  Implementation(const fs::path& path, Mode mode)
      : lock(mode == Mode::kWrite ? std::make_unique<corpus::WriterLock>(path) : nullptr), database(path, mode) {}

  void check() {
    corpus::check_kind(database, kSearchFile);
    descriptor = corpus::fact(database, "descriptor");
    std::string settings;
    try {
      for (const retrieval::Term& term : retrieval::parse_composite(descriptor))
        sizes.push_back(retrieval::descriptors().make(term.spec)->bytes());
      settings = all_settings(descriptor);
    } catch (const ParameterError& e) {
      throw std::runtime_error(database.name() + ": its descriptor is unknown to this version: " + e.what());
    }
    if (settings != corpus::fact(database, "settings"))
      throw std::runtime_error(database.name() + ": its descriptor '" + descriptor +
                               "' has other settings in this version of the program; index again into a new file");
  }

  /// The parts that are rows of `s` from column 0 (part) and 1 (bytes) on; the first is there.
  void add_part(Parts& parts, std::int64_t part, std::span<const std::uint8_t> bytes) const {
    const auto k = static_cast<std::size_t>(part);
    if (k != parts.size() || k >= sizes.size() || bytes.size() != sizes[k])
      throw std::runtime_error(database.name() + ": a signature is damaged");
    parts.emplace_back(bytes.begin(), bytes.end());
  }

  std::unique_ptr<corpus::WriterLock> lock;
  corpus::Database database;
  std::string descriptor;
  std::vector<std::size_t> sizes;  ///< bytes of each part
  std::unique_ptr<corpus::Transaction> open;
};

Database::Database(const fs::path& file, const std::string& wanted) {
  const std::string descriptor = retrieval::without_alias(wanted.empty() ? "best" : wanted);
  const std::string settings = all_settings(descriptor);  // before a file is made
  implementation_ = std::make_unique<Implementation>(file, Mode::kWrite);
  corpus::Database& database = implementation_->database;
  if (!corpus::is_empty(database)) corpus::check_kind(database, kSearchFile);  // before anything is changed
  // No file beside this one once a change is done, and each done change outlives the program.
  database.execute("PRAGMA journal_mode = TRUNCATE; PRAGMA synchronous = NORMAL; PRAGMA cache_size = -65536");
  corpus::make_tables(database, kSearchFile,
                      {{"descriptor", descriptor}, {"settings", settings}, {"version", version()}});
  implementation_->check();
  if (!wanted.empty() && implementation_->descriptor != descriptor)
    throw ParameterError(file.string() + ": holds signatures of '" + implementation_->descriptor + "', not of '" +
                         descriptor + "'");
}

Database::Database(const fs::path& file) : implementation_(std::make_unique<Implementation>(file, Mode::kHeal)) {
  implementation_->check();
}

Database::~Database() = default;
Database::Database(Database&&) noexcept = default;

bool is_database(const fs::path& file) { return corpus::is_of_kind(file, kSearchFile); }

corpus::Database& DatabaseAccess::file(Database& database) { return database.implementation_->database; }

const std::string& Database::descriptor() const { return implementation_->descriptor; }

std::vector<Member> Database::members() {
  Statement s(implementation_->database, std::string("SELECT ") + kColumns + " FROM members ORDER BY name");
  std::vector<Member> members;
  while (s.step()) members.push_back(read_member(s));
  return members;
}

std::optional<Member> Database::find(const std::string& name) {
  Statement s(implementation_->database, std::string("SELECT ") + kColumns + " FROM members WHERE name = ?1");
  return s.bind(1, name).step() ? std::optional(read_member(s)) : std::nullopt;
}

std::optional<Member> Database::find_id(std::int64_t id) {
  Statement s(implementation_->database, std::string("SELECT ") + kColumns + " FROM members WHERE id = ?1");
  return s.bind(1, id).step() ? std::optional(read_member(s)) : std::nullopt;
}

Parts Database::signature(std::int64_t id) {
  Statement s(implementation_->database, "SELECT part, bytes FROM signatures WHERE member = ?1 ORDER BY part");
  s.bind(1, id);
  Parts parts;
  while (s.step()) implementation_->add_part(parts, s.integer(0), s.bytes(1));
  if (!parts.empty() && parts.size() != implementation_->sizes.size())
    throw std::runtime_error(implementation_->database.name() + ": a signature is damaged");
  return parts;
}

std::size_t Database::described() {
  Statement s(implementation_->database, "SELECT count(*) FROM members WHERE status = 2");
  s.step();
  return static_cast<std::size_t>(s.integer(0));
}

void Database::for_each_signature(const std::function<void(Member&&, Parts&&)>& take) {
  Statement s(implementation_->database,
              std::string("SELECT ") + kColumns + " FROM members WHERE status = 2 ORDER BY name");
  Statement parts_of(implementation_->database, "SELECT part, bytes FROM signatures WHERE member = ?1 ORDER BY part");
  while (s.step()) {
    Member member = read_member(s);
    Parts parts;
    parts_of.bind(1, member.id);
    while (parts_of.step()) implementation_->add_part(parts, parts_of.integer(0), parts_of.bytes(1));
    if (parts.size() != implementation_->sizes.size())
      throw std::runtime_error(implementation_->database.name() + ": the signature of " + member.name + " is missing");
    take(std::move(member), std::move(parts));
  }
}

std::int64_t Database::put(const Member& member, const Parts* parts) {
  Implementation& i = *implementation_;
  std::optional<corpus::Transaction> own;
  if (!i.open) own.emplace(i.database);
  Statement s(i.database, std::string("INSERT OR REPLACE INTO members(") + kColumns +
                              ") VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10) RETURNING id");
  if (member.id != 0) s.bind(1, member.id);
  s.bind(2, std::string_view(member.name)).bind(3, std::string_view(member.source));
  s.bind(4, std::string_view(member.digest)).bind(5, static_cast<std::int64_t>(member.status));
  s.bind(6, static_cast<std::int64_t>(member.faces)).bind(7, member.rectilinearity).bind(8, member.size);
  s.bind(9, std::string_view(member.error)).bind(10, member.seconds);
  s.step();
  const std::int64_t id = s.integer(0);
  s.run();
  Statement clear(i.database, "DELETE FROM signatures WHERE member = ?1");
  clear.bind(1, id).run();
  if (parts) {
    Statement add(i.database, "INSERT INTO signatures(member, part, bytes) VALUES(?1, ?2, ?3)");
    for (std::size_t k = 0; k < parts->size(); ++k)
      add.bind(1, id).bind(2, static_cast<std::int64_t>(k)).bind(3, retrieval::SignatureView((*parts)[k])).run();
  }
  if (own) own->commit();
  return id;
}

void Database::rename(const Member& member) {
  Statement s(implementation_->database, "UPDATE members SET name = ?2, source = ?3, digest = ?4 WHERE id = ?1");
  s.bind(1, member.id).bind(2, std::string_view(member.name)).bind(3, std::string_view(member.source));
  s.bind(4, std::string_view(member.digest)).run();
}

void Database::remove(std::int64_t id) {
  for (const char* sql : {"DELETE FROM signatures WHERE member = ?1", "DELETE FROM members WHERE id = ?1"})
    Statement(implementation_->database, sql).bind(1, id).run();
}

void Database::begin_run(const std::string& shard) {
  corpus::Database& file = implementation_->database;
  const double now = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  Statement finished(file, "SELECT count(*) FROM members WHERE status > 0");
  finished.step();
  corpus::set_fact(file, "shard", shard);
  corpus::set_fact(file, "started", std::to_string(now));
  corpus::set_fact(file, "finished_before", std::to_string(finished.integer(0)));
}

void Database::begin() { implementation_->open = std::make_unique<corpus::Transaction>(implementation_->database); }

void Database::commit() {
  implementation_->open->commit();
  implementation_->open.reset();
}

}  // namespace rectilin::search
