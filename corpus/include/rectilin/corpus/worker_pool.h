// Worker processes that do one mesh after another, so that a mesh that crashes or hangs the program costs only itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rectilin/base/batch.h"
#include "rectilin/corpus/claims.h"
#include "rectilin/corpus/store.h"
#include "rectilin/mesh/source.h"

namespace rectilin::corpus {

struct WorkerOptions {
  /// The command, with its arguments, that starts a worker: a program that calls run_worker(3, ...). Its first word is
  /// a path.
  std::vector<std::string> worker_command;
  int workers = 1;                      ///< worker processes at a time
  std::optional<double> seconds;        ///< time limit for each mesh, reading it included
  std::optional<std::uint64_t> memory;  ///< bytes that a worker may use on top of what it has when it starts
};

/// What became of a job.
struct Answer {
  RowStatus status = RowStatus::kDone;  ///< done, failed or limited
  Json result;                          ///< WorkResult::result; null if there is none
  std::string bytes;                    ///< WorkResult::bytes
  std::string error;                    ///< why it failed or was limited
  double seconds = 0;                   ///< wall clock
};

/// Whoever gives out jobs and takes the answers.
class JobHandler {
 public:
  virtual ~JobHandler() = default;
  /// A worker has read the mesh of a job: JSON {digest, report, left_out}. If workers share no claims, this comes right
  /// before finish().
  virtual void read(std::size_t /*job*/, const Json& /*about*/) {}
  /// The same, of a mesh that another job has claimed, or that was done before: is the work wanted? If not, the job is
  /// over without an answer.
  virtual bool is_wanted(std::size_t /*job*/, const Json& /*about*/) { return true; }
  virtual void finish(std::size_t job, Answer&& answer) = 0;
};

/// Does jobs in worker processes and tells the handler, one call at a time, in the order in which they end. A job whose
/// worker hangs, crashes or takes too much memory is limited, and the worker is replaced. The search in a job may take
/// `seconds`; a worker that is silent for 1.1 times that and one second more is killed. With `claims`, work on a mesh
/// is done for the job that claims it first; of other jobs with that mesh the handler is asked. After a stop the jobs
/// in work are not finished. Throws std::runtime_error if workers do not start, and what the handler throws.
void run_jobs(std::span<const NamedSource> jobs, const Task& task, const WorkerOptions& options, const Claims* claims,
              JobHandler& handler, const LoopControl& control = {});

}  // namespace rectilin::corpus
