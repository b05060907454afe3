// The worker process of run_jobs(): it does one mesh after another, and may crash doing so.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "rectilin/base/parameters.h"
#include "rectilin/corpus/store.h"

namespace rectilin::corpus {

/// The result of the work on one mesh.
struct WorkResult {
  Json result;             ///< a JSON object, without times, so that equal meshes have equal results
  bool time_over = false;  ///< the search ran out of time: the result is valid but could be better
  std::string bytes = {};  ///< what does not go into JSON
};

/// Does the work of a task on a mesh that has been read. `job` is what run_jobs() was given. It throws if the mesh
/// cannot be done.
using Work = std::function<WorkResult(const NamedSource& job, const LoadedMesh& mesh)>;

/// Makes the function that does a task's work; throws ParameterError if there is no such task. `seconds` is the time
/// that a search may take, if it is limited.
using MakeWork = std::function<Work(const Task& task, std::optional<double> seconds)>;

/// The main loop of a worker: takes meshes from `socket`, on which run_jobs() sends them, until there are no more. The
/// next file descriptor is that of the claims, if workers share any. It limits the memory of its own process as
/// run_jobs() demands. Returns the exit status.
int run_worker(int socket, const MakeWork& make_work);

}  // namespace rectilin::corpus
