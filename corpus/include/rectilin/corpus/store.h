// A store: a file that holds one row for each mesh of a collection.
//
// A store is an SQLite database. A mesh's row is on record as soon as the mesh is done, whenever the program ends.
// Meshes still to be done have rows, too, so that a store tells how far it is. It can be read with `sqlite3 FILE.db`
// while it is written:
//
//     meshes   name (the key), source, class, status, digest (of the mesh, see mesh_digest()), columns of the result
//              (faces, area, rectilinearity, lower, upper), result and report as JSON, error, version (of the program),
//              finished (seconds since 1970), seconds (that the mesh took)
//     facts    task and settings, the same for all rows
//     runs     who wrote when, and which shard
//
// Results contain no times, so that equal work gives equal bits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/base/parameters.h"
#include "rectilin/corpus/shard.h"
#include "rectilin/mesh/source.h"

namespace rectilin::corpus {

/// Stored as these numbers. Of two rows for one mesh the one with the higher number is kept.
enum class RowStatus : std::int64_t {
  kLeft = 0,     ///< not done yet
  kLimited = 1,  ///< too slow, too large or crashed, as `error` says; tried again only on request
  kFailed = 2,   ///< not a mesh that can be measured; `error` says why
  kDone = 3,     ///< has a result
};

const char* to_string(RowStatus status);

struct Row {
  std::string name, source, group;
  RowStatus status = RowStatus::kLeft;
  std::string digest;          ///< empty if the mesh could not be read
  std::string result, report;  ///< JSON objects as text; empty if there are none
  std::string error;
  std::string version;
  double finished = 0, seconds = 0;
  bool operator==(const Row&) const = default;
};

/// The task whose results a store holds. Stores of different tasks cannot be mixed.
struct Task {
  std::string name;  ///< "measure", "pose" or "compare"
  Json settings;
  bool operator==(const Task&) const = default;
};

/// How two tasks differ, for error messages: "'measure' with {"seed":1}, not with {"seed":2}".
std::string difference(const Task& found, const Task& wanted);

/// A store that is open. Not thread safe. Throws std::runtime_error, "FILE: reason", if the file cannot be read or
/// written or is not a store.
class Store {
 public:
  /// Opens a store for writing, or makes one. Throws ParameterError if it holds results of another task, and
  /// std::runtime_error if another program is writing to it.
  Store(const std::filesystem::path& file, const Task& task);
  /// Opens a store for reading.
  explicit Store(const std::filesystem::path& file);
  ~Store();
  Store(Store&&) noexcept;

  Task task() const;

  /// Records that a run begins on these meshes. Meshes without a row get one that is to be done, and rows still to be
  /// done of meshes that are not in the list are removed. With `retry`, meshes that failed or were limited are to be
  /// done again. Returns the indices of the meshes to be done, in their order. Throws ParameterError if two different
  /// sources have the same name.
  std::vector<std::size_t> begin_run(std::span<const NamedSource> meshes, const Shard& shard, bool retry);
  void end_run();

  /// Replaces the row of that name. Once it returns, the row survives the end of the program.
  void put(const Row& row);

  /// Of the meshes that are done.
  std::vector<std::string> digests();
  /// The row of a finished mesh with this digest, if there is one.
  std::optional<Row> find_digest(std::string_view digest);
  std::optional<Row> find(std::string_view name);

  /// In the order of their names.
  void for_each(const std::function<void(const Row&)>& take);
  std::size_t size();

 private:
  friend class StoreAccess;
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Is the file a store? False for one that cannot be read.
bool is_store(const std::filesystem::path& file);

}  // namespace rectilin::corpus
