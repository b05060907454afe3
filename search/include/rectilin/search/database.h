// A collection's signatures in one file.
//
// An SQLite database that survives the end of the program at any moment: a file's row is there as soon as its signature
// is. It can be read by any number of programs while one writes, and with `sqlite3 FILE.db`:
//
//     members      id, name (unique; the file as it was given), source (where it lies, from the root), digest (of its
//                  bytes), status (0 left to be done, 1 failed, 2 done), faces, rectilinearity, size (longest side of
//                  the box around it, in the file's unit), error, seconds (that the signature took)
//     signatures   member (an id), part (0, 1, ... of the descriptor's terms), bytes
//     facts        descriptor, as the text it was made from; settings, all of them; version of the program; shard,
//                  started (seconds since 1970) and finished_before (members) of the last run
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::search {

enum class MemberStatus : std::int64_t {
  kLeft = 0,    ///< to be described
  kFailed = 1,  ///< is no mesh, or has no signature; `error` says why
  kDone = 2,    ///< has a signature
};

struct Member {
  std::int64_t id = 0;  ///< given by the database
  std::string name, source, digest;
  MemberStatus status = MemberStatus::kLeft;
  std::size_t faces = 0;
  double rectilinearity = 0, size = 0, seconds = 0;
  std::string error;
};

/// One signature for each term of the descriptor.
using Parts = std::vector<retrieval::Signature>;

/// Not thread safe. Throws std::runtime_error, "FILE: reason", if the file cannot be read or written, is damaged, is
/// another kind of file or was written by a version of the program whose signatures differ.
class Database {
 public:
  /// Opens a database for writing, or makes one, whose signatures are of a descriptor (a text for make_descriptor());
  /// if that is empty, of the one that the file has, "best" for a new file. Throws ParameterError if the file holds those
  /// of another, std::runtime_error if another program writes to it.
  Database(const std::filesystem::path& file, const std::string& descriptor);
  /// Opens one for reading.
  explicit Database(const std::filesystem::path& file);
  ~Database();
  Database(Database&&) noexcept;

  const std::string& descriptor() const;

  /// In the order of their names.
  std::vector<Member> members();
  std::optional<Member> find(const std::string& name);
  std::optional<Member> find_id(std::int64_t id);
  /// Empty for a member that is not done.
  Parts signature(std::int64_t id);
  std::size_t described();  ///< how many members are done
  /// Members that are done, in the order of their names, each with its signature.
  void for_each_signature(const std::function<void(Member&&, Parts&&)>& take);

  /// Adds a member or, if its id is not 0, replaces it; `parts` may be null if it has none. For good when it returns,
  /// unless between begin() and commit(). Returns its id.
  std::int64_t put(const Member& member, const Parts* parts);
  /// A member's name, source and digest, all else as it is.
  void rename(const Member& member);
  void remove(std::int64_t id);

  /// Records that work on this part, "I/N", begins, for status_of().
  void begin_run(const std::string& shard);

  /// Changes that are made all or none: those between begin() and commit().
  void begin();
  void commit();

 private:
  friend class DatabaseAccess;
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Is the file such a database? False for one that cannot be read.
bool is_database(const std::filesystem::path& file);

}  // namespace rectilin::search
