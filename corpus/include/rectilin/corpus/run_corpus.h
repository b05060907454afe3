// Works on all meshes of a collection in worker processes, so that a mesh that crashes or hangs the program costs only
// its own row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/corpus/shard.h"
#include "rectilin/corpus/store.h"
#include "rectilin/corpus/worker_pool.h"

namespace rectilin::corpus {

struct CorpusOptions : WorkerOptions {
  bool retry = false;                       ///< do meshes again that failed or were limited
  bool share = true;                        ///< work on meshes with the same digest once: results depend on no names
  std::vector<std::filesystem::path> done;  ///< other stores of this task: their meshes are skipped
  /// Called for each row once it is in the store, one call at a time, with summary() of what the mesh's reader
  /// left out.
  std::function<void(const Row& row, const std::string& left_out)> on_row = {};
};

struct CorpusSummary {
  std::size_t done = 0, failed = 0, limited = 0;  ///< counts of this run
  std::size_t copied = 0;                         ///< how many of `done` are equal to another mesh and got its result
  std::size_t before = 0;                         ///< meshes that the store had before
  std::size_t left = 0;                           ///< meshes not done because of a stop
};

/// Does the meshes that are in the shard and not yet in the store, by run_jobs(). One that hangs, crashes or takes too
/// much memory gets a row that says so. A result's `times`, if it has such a member, goes into the row's report, since
/// results must not differ between equal runs. After a stop the meshes in work are left for the next run. Throws what
/// Store and run_jobs() throw.
CorpusSummary run_corpus(std::span<const NamedSource> meshes, const Shard& shard, Store& store, const Task& task,
                         const CorpusOptions& options, const LoopControl& control = {});

}  // namespace rectilin::corpus
