// Runs a comparison: K runs of every optimizer on every mesh, each run from its own seed and on its own random rotation
// of the mesh, all on the same budget.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/laboratory/plan.h"
#include "rectilin/laboratory/work.h"
#include "rectilin/optim/objective.h"
#include "rectilin/report/plot.h"

namespace rectilin::laboratory {

/// Progress of a comparison.
struct ComparisonProgress {
  std::size_t done = 0, total = 0;  ///< runs, including those of an earlier start
  double seconds_left =
      std::numeric_limits<double>::infinity();  ///< estimated; infinite while there is nothing to go by
  std::string text;                             ///< what is being done
};

struct ComparisonSettings {
  std::stop_token stop = {};
  std::string command_line = {};                                    ///< for the record in provenance.json
  std::function<void(const ComparisonProgress&)> on_progress = {};  ///< called from any thread, one at a time
  /// Loads the mesh of a name in the plan; called once for each, one at a time. If it throws, that is the error of
  /// this mesh.
  std::function<ComparedMesh(const std::string& name)> load = load_compared_mesh;
  /// Makes the objective of a mesh, if Plan::objective is not kRectilinearity; called right after `load`.
  std::function<std::shared_ptr<const Objective>(const std::string& name)> objective = {};
  /// Also write the report (see write_report()) when all runs are done.
  bool report = false;
};

struct ComparisonOutcome {
  bool complete = false;  ///< all runs of the plan are done
  std::size_t failed_runs = 0;
  std::vector<std::string> mesh_errors;  ///< one line for each mesh that could not be measured
  std::vector<std::string> losses;       ///< one line for each mesh that is not all that its file holds
  report::PictureTroubles pictures;      ///< what went wrong with the report's plots
};

/// Does the runs of `plan` that are not yet in `folder`, which is made if necessary and afterwards holds
/// - plan.json: the plan; provenance.json: see record_start();
/// - meshes.jsonl: a line for each mesh with its digest and certified bounds of R, or the reason why it cannot
///   be measured;
/// - runs.jsonl: a line for each finished run, written when it finishes: to_json(RunRecord) and `mesh`, `entry` (the
///   label), `run`, `instance` (the mesh's rotation) and the `trace` (arrays `evaluations`, `seconds`, `merit`: R of
///   the best rotation so far, wherever it rose).
/// Several runs go on at a time, each on one thread. So their lines can come in any order, but what the lines say,
/// except for times, depends on the plan alone. The bounds of the meshes are proved first, one mesh at a time with all
/// threads. Throws ParameterError for a plan that check() refuses, if the folder holds a comparison with another plan,
/// or if a mesh has changed since; std::runtime_error if the folder cannot be written or another program is writing
/// there. A stop keeps the finished runs; call again to resume.
ComparisonOutcome run_comparison(const Plan& plan, const std::filesystem::path& folder, const Registry& registry,
                                 const ComparisonSettings& settings = {});

/// Makes such a folder, with its report, from lines that were made elsewhere (see ComparisonWork). Throws what
/// run_comparison() throws, and ParameterError if the folder holds runs that are not among them.
report::PictureTroubles write_comparison(const Plan& plan, const std::filesystem::path& folder,
                                         const Registry& registry, const std::string& command_line,
                                         const std::vector<Json>& meshes, const std::vector<Json>& runs);

}  // namespace rectilin::laboratory
