// Comparisons in stores: a row for the bounds of each mesh and one for each run, so that they can be sharded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rectilin/corpus/worker.h"
#include "rectilin/laboratory/plan.h"
#include "rectilin/optim/objective.h"

namespace rectilin::app {

inline constexpr const char* kCompareTask = "compare";

/// The objective of a plan that names another than R.
std::shared_ptr<const Objective> other_objective(const LoadedMesh& loaded, const std::string& name);

corpus::Task compare_task(const laboratory::Plan& plan);

/// The rows of a comparison. Names are "MESH | bounds" and "MESH | OPTIMIZER | RUN", with runs from 1; the class of a
/// run is its optimizer.
std::vector<NamedSource> compare_jobs(const laboratory::Plan& plan);

corpus::Work compare_work(const Json& settings);

/// Makes the folder of a comparison with its page from a store. Returns the exit status, 1 if anything is missing.
int compare_from_store(const std::string& store, const std::string& folder, const std::string& command_line);

}  // namespace rectilin::app
