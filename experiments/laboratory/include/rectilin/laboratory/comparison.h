// Runs a comparison: K seeded runs of every optimizer on random rotations of every mesh, one budget for all.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/laboratory/plan.h"
#include "rectilin/measure/area_vectors.h"
#include "rectilin/optim/objective.h"

namespace rectilin::laboratory {

/// Progress of a comparison.
struct ComparisonProgress {
  std::size_t done = 0, total = 0;                                ///< runs, those of an earlier start included
  double seconds_left = std::numeric_limits<double>::infinity();  ///< estimated; infinite while nothing is known
  std::string text;                                               ///< what goes on
};

/// What a comparison needs of a mesh.
struct ComparedMesh {
  AreaVectors vectors;
  std::size_t faces = 0;
  std::string digest;  ///< tells another mesh from this one when a comparison goes on
};

/// That of load_mesh(), with its mesh_digest().
ComparedMesh load_compared_mesh(const std::string& source);

struct ComparisonSettings {
  std::stop_token stop = {};
  std::string command_line = {};                                    ///< for the record
  std::function<void(const ComparisonProgress&)> on_progress = {};  ///< called from any thread, one at a time
  /// Makes the mesh of a name in the plan; called once for each, one at a time. What it throws is that mesh's error.
  std::function<ComparedMesh(const std::string& name)> load = load_compared_mesh;
  /// Makes the objective of a mesh if Plan::objective is another than kRectilinearity; called as `load` is.
  std::function<std::shared_ptr<const Objective>(const std::string& name)> objective = {};
};

struct ComparisonOutcome {
  bool complete = false;  ///< nothing is left to run
  std::size_t failed_runs = 0;
  std::vector<std::string> mesh_errors;  ///< one line for each mesh that could not be measured
};

/// Does what is left of `plan` in `folder`, which is made if need be and afterwards holds
/// - plan.json: the plan; provenance.json: see record_start();
/// - meshes.jsonl: a line for each mesh with its digest and certified bounds of R, or why it cannot be measured;
/// - runs.jsonl: a line for each finished run, written when it finishes: to_json(RunRecord) and `mesh`, `entry`
///   (the label), `run`, `instance` (the mesh's rotation) and the `trace` (arrays `evaluations`, `seconds`,
///   `merit`: R of the best rotation so far, wherever it rose).
/// Runs go on beside each other, each confined to one thread; so lines come in any order, but what they say, times
/// apart, depends on the plan alone. Certificates come first, one mesh at a time with all threads.
/// Throws ParameterError for a plan that check() refuses, or if the folder holds another plan or a mesh has changed
/// since, std::runtime_error if the folder cannot be written or another program is writing there. A stop leaves
/// finished runs in place; call again to go on.
ComparisonOutcome run_comparison(const Plan& plan, const std::filesystem::path& folder, const Registry& registry,
                                 const ComparisonSettings& settings = {});

}  // namespace rectilin::laboratory
