// The pieces of work that a comparison consists of: each depends on the plan and the mesh alone, so that it can be done
// anywhere and in any order.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/laboratory/plan.h"
#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/measure.h"
#include "rectilin/mesh/mesh_io.h"
#include "rectilin/optim/objective.h"

namespace rectilin::laboratory {

/// What a comparison needs to know about a mesh.
struct ComparedMesh {
  AreaVectors vectors;
  std::size_t faces = 0;
  std::string digest;         ///< tells whether the mesh has changed when a comparison is resumed
  std::string left_out = {};  ///< what the reader left out: summary() of its report
};

/// Loads a mesh with load_mesh() and digests it with mesh_digest().
ComparedMesh load_compared_mesh(const std::string& source);
ComparedMesh compared_mesh(const LoadedMesh& loaded);

/// A mesh of a plan.
struct Problem {
  std::string name;  ///< in the plan
  ComparedMesh mesh;
  std::shared_ptr<const Objective> other = {};  ///< what is searched instead of R, if the plan says so
};

/// Immutable and thread safe. Results are lines of meshes.jsonl and runs.jsonl, see run_comparison().
class ComparisonWork {
 public:
  /// Throws ParameterError for an optimizer that the registry cannot make.
  ComparisonWork(const Plan& plan, const Registry& registry);

  const Plan& plan() const { return plan_; }

  /// Proves bounds of R for the mesh as it is or, if nothing can be proved, searches for the best known value; nothing
  /// if it was stopped.
  std::optional<Json> bound(const Problem& problem, std::stop_token stop = {},
                            const std::function<void(const Evaluator&)>& on_progress = {}) const;
  /// The line of a mesh that could not be measured.
  static Json unmeasured(const std::string& mesh, const std::string& error);

  /// A run of an entry of the plan; nothing if it was stopped.
  std::optional<Json> run(const Problem& problem, std::size_t entry, int run, std::stop_token stop = {}) const;
  /// The line of a run that crashed, or took too long or too much memory.
  Json failed_run(const std::string& mesh, std::size_t entry, int run, const std::string& error) const;

 private:
  std::optional<Json> search_reference(const Problem& problem, std::stop_token stop) const;
  Json run_line(const std::string& mesh, std::size_t entry, int run, const RunRecord& record) const;

  Plan plan_;
  MeasureOptions certifier_;
  std::unique_ptr<const Optimizer> reference_;  // takes the place of the certifier if there is no proof
  std::vector<std::unique_ptr<const Optimizer>> optimizers_;
};

/// Takes the times, which differ between equal runs, out of a line, and puts them back.
Json take_times(Json& line);
void put_times(Json& line, const Json& times);

}  // namespace rectilin::laboratory
