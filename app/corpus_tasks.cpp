#include "corpus_tasks.h"

#include "compare_store.h"
#include "poser.h"
#include "rectilin/measure/measure.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/search/index_worker.h"

namespace rectilin::app {
namespace {

/// Results leave out times, which differ between equal runs; the rows of the store have columns for them.
constexpr const char* kTimes[] = {"seconds", "cpu_seconds", "threads"};

corpus::Work measure_work(const Json& settings, std::optional<double> seconds) {
  MeasureOptions options = measure_options(settings["optimizer"].get<std::string>(), all_optimizers());
  if (!settings["gap"].is_null()) options.certify.gap = settings["gap"];
  if (settings["optima"] == true) options.certify.optima = true;
  options.run.seed = settings["seed"];
  options.run.domain = &domain_by_name(settings["domain"].get<std::string>());
  Budget& budget = options.run.budget;
  if (!settings["evaluations"].is_null()) budget.evaluations = settings["evaluations"].get<std::uint64_t>();
  if (seconds) budget.seconds = *seconds;
  return [options](const NamedSource&, const LoadedMesh& mesh) {
    const Rectilinearity r = measure(mesh.mesh, options);
    corpus::WorkResult done{to_json(r), false};
    done.time_over = r.run.outcome == RunRecord::Outcome::kBudget && options.run.budget.limits_seconds() &&
                     r.run.costs.evaluations() < options.run.budget.evaluations;
    for (const char* key : kTimes) done.result.erase(key);
    return done;
  };
}

}  // namespace

corpus::Work make_work(const corpus::Task& task, std::optional<double> seconds) {
  if (task.name == "measure") return measure_work(task.settings, seconds);
  if (task.name == kPoseTask) return pose_work(task.settings);
  if (task.name == kCompareTask) return compare_work(task.settings);
  if (task.name == search::kIndexTask) return search::make_index_work(task.settings);
  throw ParameterError("no task '" + task.name + "'");
}

}  // namespace rectilin::app
