// Kinds of SQLite files: what marks a file as one of ours, its tables, and facts about all of its rows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rectilin/corpus/sqlite.h"

namespace rectilin::corpus {

struct FileKind {
  std::int64_t application;  ///< SQLite's application_id: marks the file
  std::int64_t version;      ///< of the tables
  const char* tables;        ///< SQL that makes the tables; one of them is facts(key, value)
  const char* name;          ///< for error messages: "a store"
};

/// What holds for all rows, by name.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Has the file no tables, as one that was just made?
bool is_empty(Database& database);

/// Gives a file that has no tables those of its kind, and these facts; leaves any other file as it is.
void make_tables(Database& database, const FileKind& kind, const Facts& facts);

/// Throws std::runtime_error if the file is of another kind, or was written by a version with other tables.
void check_kind(Database& database, const FileKind& kind);

/// Is it an SQLite file of this kind, of whatever version? False for a file that cannot be read.
bool is_of_kind(const std::filesystem::path& file, const FileKind& kind);

/// Empty if there is no such fact.
std::string fact(Database& database, std::string_view key);
void set_fact(Database& database, std::string_view key, std::string_view value);

}  // namespace rectilin::corpus
