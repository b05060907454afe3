// The same run for any number of threads, for every optimizer, on a mesh whose sums threads share;
// and for any number of seconds, as far as they go.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

/// So many directions that batches of values, cuts, smooth values and turns are all split into
/// tasks.
constexpr int kDirections = 40'000;

const ProjectedArea& many_directions(SumMethod evaluation) {
  const auto make = [](SumMethod how) {
    Random random(3);
    std::vector<Vector3> vectors(kDirections);
    for (Vector3& v : vectors) v = {random.normal(), 2 * random.normal(), 4 * random.normal()};
    return std::make_unique<ProjectedArea>(area_vectors(std::move(vectors)), "many directions", how);
  };
  static const auto tree = make(SumMethod::kTree), flat = make(SumMethod::kFlat);
  return evaluation == SumMethod::kTree ? *tree : *flat;
}

RunRecord run_on_threads(int threads, const Optimizer& optimizer, const Objective& objective,
                         std::uint64_t evaluations) {
  // More threads than there are cores; the library wants to be told.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  return arena.execute([&] { return run_optimizer(optimizer, objective, {.budget = {.evaluations = evaluations}}); });
}

void require_same(const RunRecord& a, const RunRecord& b) {
  REQUIRE(a.digest == b.digest);
  REQUIRE(a.costs.evaluations() == b.costs.evaluations());
  REQUIRE(a.value_bound == b.value_bound);
  REQUIRE(a.trace.size() == b.trace.size());
  for (std::size_t i = 0; i < a.trace.size(); ++i) {
    REQUIRE(a.trace[i].evaluations == b.trace[i].evaluations);
    REQUIRE(a.trace[i].value == b.trace[i].value);
    REQUIRE(a.trace[i].lower == b.trace[i].lower);
  }
}

void require_same_on_threads(const std::string& spec, SumMethod evaluation, std::uint64_t evaluations) {
  const auto optimizer = all_optimizers().make(spec);
  if (!optimizer->capabilities().deterministic) return;
  INFO(spec);
  const ProjectedArea& objective = many_directions(evaluation);
  const RunRecord one = run_on_threads(1, *optimizer, objective, evaluations);
  REQUIRE(one.outcome != RunRecord::Outcome::kFailed);
  REQUIRE(one.costs.evaluations() > 0);
  for (const int threads : {2, 8}) require_same(one, run_on_threads(threads, *optimizer, objective, evaluations));
}

}  // namespace

TEST_CASE("every optimizer runs the same on 1, 2 and 8 threads", "[determinism]") {
  for (const auto& entry : all_optimizers().entries()) require_same_on_threads(entry.name, SumMethod::kTree, 500);
  for (const char* spec :
       {"super-fibonacci?count=60+nelder-mead", "ga?generations=2+ceres", "random?evaluations=50+axis-sweep",
        "multistart?local=nlopt:LD_LBFGS", "nlopt:G_MLSL?local=LD_SLSQP", "grid?points=4+certify"})
    require_same_on_threads(spec, SumMethod::kTree, 500);
}

TEST_CASE("what asks in batches runs the same on any threads with flat sums, too", "[determinism]") {
  for (const auto& entry : all_optimizers().entries())
    if (all_optimizers().make(entry.name)->capabilities().batches)
      require_same_on_threads(entry.name, SumMethod::kFlat, 500);
}

TEST_CASE("a limit of time cuts a run off, and changes nothing before", "[determinism]") {
  for (const auto& entry : all_optimizers().entries()) {
    INFO(entry.name);
    const RunRecord a = test::run_on_pyramid(entry.name, 1, {.seconds = 0.01});
    const RunRecord b = test::run_on_pyramid(entry.name, 1, {.seconds = 0.02});
    REQUIRE(a.outcome != RunRecord::Outcome::kFailed);
    const std::size_t common = std::min(a.trace.size(), b.trace.size());
    for (std::size_t i = 0; i + 1 < common; ++i) {
      REQUIRE(a.trace[i].value == b.trace[i].value);
      REQUIRE(a.trace[i].evaluations == b.trace[i].evaluations);
    }
  }
}
