// Bringing a database up to what folders hold.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/corpus/shard.h"
#include "rectilin/corpus/worker_pool.h"
#include "rectilin/search/database.h"

namespace rectilin::search {

struct IndexOptions {
  corpus::Shard shard = {};                 ///< only the members of this part, by their names
  bool retry = false;                       ///< describe files again that failed before
  std::vector<std::filesystem::path> done;  ///< other databases: files that they have with the same bytes are skipped
  /// Describe in worker processes, so that a mesh that hangs, crashes or fills the memory is a file that failed.
  /// Without them, meshes are described in threads of this program and without limits.
  std::optional<corpus::WorkerOptions> workers = {};
};

struct IndexSummary {
  std::size_t unchanged = 0;        ///< were there already, the file's bytes the same
  std::size_t added = 0;            ///< described now, files that were not there
  std::size_t changed = 0;          ///< described again, for the file is another
  std::size_t moved = 0;            ///< the same bytes under another name, the old one gone
  std::size_t copied = 0;           ///< the same bytes as another member: its signature was taken
  std::size_t removed = 0;          ///< members whose files are gone
  std::size_t elsewhere = 0;        ///< are in IndexOptions::done
  std::vector<std::string> errors;  ///< a line for each file that failed now or is known to
  bool complete = false;            ///< false if it was stopped; the same call goes on
};

/// Makes the database's members what `sources` name: files, folders with all below, archives, lists (see
/// expand_sources()). Members elsewhere, under none of the sources or in other shards, stay as they are. Several meshes
/// are described at a time; the database is the same for any number of threads or workers, but for seconds. A file that
/// fails becomes a row that says why and is tried again when its bytes change. Progress is over the files that need
/// work. Throws ParameterError if a database in `done` has another descriptor.
IndexSummary update_index(Database& database, const std::vector<std::string>& sources, const LoopControl& control = {},
                          const IndexOptions& options = {});

}  // namespace rectilin::search
