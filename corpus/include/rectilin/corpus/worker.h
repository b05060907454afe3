// The other end of a corpus' run: a process that does one mesh after another and may die of it.
#pragma once

#include <functional>
#include <optional>

#include "rectilin/base/parameters.h"
#include "rectilin/corpus/store.h"

namespace rectilin::corpus {

/// What work on a mesh came to.
struct WorkResult {
  Json result;             ///< an object; without times, so that equal meshes have equal results
  bool time_over = false;  ///< the search ended when its seconds did: the result holds, but more time would better it
};

/// Does a task's work on a mesh that has been read; throws what is the mesh's fault.
using Work = std::function<WorkResult(const LoadedMesh& mesh)>;

/// Makes the work of a task; throws ParameterError if there is no such task. `seconds` is what a search may take, if
/// that is limited.
using MakeWork = std::function<Work(const Task& task, std::optional<double> seconds)>;

/// A worker's life: takes meshes from `socket`, on which run_corpus() sends them, until there are no more. Limits the
/// memory of this process as it is told to. Returns the exit status.
int run_worker(int socket, const MakeWork& make_work);

}  // namespace rectilin::corpus
