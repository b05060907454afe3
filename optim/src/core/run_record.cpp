#include "rectilin/optim/run_record.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <iomanip>
#include <limits>
#include <sstream>

namespace rectilin {
namespace {

Json finite_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

std::string hex(std::uint64_t x) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << x;
  return text.str();
}

/// The number of threads that parallel loops started here can use.
int usable_threads() {
  const std::size_t limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(limit));
}

/// Processor time so far: only of this thread if a run may use no other, so that runs beside it are not counted.
double cpu_clock(int threads) {
  std::timespec time{};
  clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

RunRecord run_optimizer(const Optimizer& optimizer, const Objective& objective, const RunSettings& settings) {
  return run_search(optimizer, objective, settings,
                    [&](Evaluator& evaluator, Random& random) { optimizer.run(evaluator, *settings.domain, random); });
}

RunRecord run_search(const Optimizer& optimizer, const Objective& objective, const RunSettings& settings,
                     const std::function<void(Evaluator& evaluator, Random& random)>& search) {
  RunRecord record;
  record.objective = objective.name();
  record.optimizer = optimizer.name();
  record.parameters = optimizer.parameters();
  record.domain = settings.domain->name();
  record.seed = settings.seed;
  record.threads = usable_threads();

  const double cpu_before = cpu_clock(record.threads);
  Evaluator evaluator(objective, settings.budget, settings.stop);
  if (settings.on_progress) evaluator.watch(settings.on_progress);
  Random random(settings.seed);
  try {
    require_needs(optimizer, objective);
    search(evaluator, random);
    if (settings.stop.stop_requested()) record.outcome = RunRecord::Outcome::kStopped;
    else if (evaluator.exhausted()) record.outcome = RunRecord::Outcome::kBudget;
  } catch (const std::exception& e) {
    record.outcome = RunRecord::Outcome::kFailed;
    record.error = e.what();
  }
  record.seconds = evaluator.seconds();
  record.cpu_seconds = cpu_clock(record.threads) - cpu_before;

  record.incumbent = evaluator.incumbent();
  record.incumbent.rotation = reduce_to_zone(record.incumbent.rotation);
  record.value_bound = evaluator.lower_bound();
  record.merit =
      evaluator.has_incumbent() ? objective.merit(record.incumbent.value) : std::numeric_limits<double>::quiet_NaN();
  record.costs = evaluator.costs();
  record.digest = evaluator.digest();
  record.trace = evaluator.trace();
  return record;
}

std::string to_string(RunRecord::Outcome outcome) {
  switch (outcome) {
    case RunRecord::Outcome::kFinished:
      return "finished";
    case RunRecord::Outcome::kBudget:
      return "budget";
    case RunRecord::Outcome::kStopped:
      return "stopped";
    case RunRecord::Outcome::kFailed:
      return "failed";
  }
  return "";
}

Json to_json(const Rotation& rotation) {
  Json rows = Json::array();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d row = rotation.axis(k);
    rows.push_back({row.x(), row.y(), row.z()});
  }
  return rows;
}

Json to_json(const RunRecord& record) {
  return {{"objective", record.objective},
          {"optimizer", record.optimizer},
          {"parameters", record.parameters},
          {"domain", record.domain},
          {"seed", record.seed},
          {"outcome", to_string(record.outcome)},
          {"error", record.error},
          {"value", finite_or_null(record.incumbent.value)},
          {"value_bound", record.value_bound ? Json(*record.value_bound) : Json(nullptr)},
          {"merit", finite_or_null(record.merit)},
          {"rotation", to_json(record.incumbent.rotation)},
          {"evaluations", record.costs.evaluations()},
          {"values", record.costs.values},
          {"cuts", record.costs.cuts},
          {"smooths", record.costs.smooths},
          {"turns", record.costs.turns},
          {"seconds", record.seconds},
          {"cpu_seconds", record.cpu_seconds},
          {"threads", record.threads},
          {"digest", hex(record.digest)}};
}

}  // namespace rectilin
