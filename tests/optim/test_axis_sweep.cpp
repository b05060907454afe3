#include "support/catch.h"
#include "support/frame_objective.h"
#include "support/known_shapes.h"

using namespace rectilin;

TEST_CASE("axis-sweep finds the pyramid's minimum and spends the budget on restarts", "[axis-sweep]") {
  const RunRecord record = test::run_on_pyramid("axis-sweep", 1, {.evaluations = 5000});
  REQUIRE(record.merit == Approx(test::kPyramid).margin(1e-12));  // exact turns: rounding only
  REQUIRE(record.costs.turns == 5000 / Costs::kPerTurn);
  REQUIRE(record.costs.values == 0);
}

TEST_CASE("where one sweep ends no turn about an axis helps", "[axis-sweep]") {
  const auto once = builtin_optimizers().make("axis-sweep?starts=1");
  REQUIRE(once->capabilities().local);
  const RunRecord record = run_optimizer(*once, test::pyramid(), {});
  REQUIRE(record.outcome == RunRecord::Outcome::kFinished);
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Rotation turned =
        rotation_from_vector(random.uniform(-1, 1) * Eigen::Vector3d::Unit(i % 3)) * record.incumbent.rotation;
    double value;
    test::pyramid().values({&turned, 1}, {&value, 1});
    REQUIRE(value >= record.incumbent.value - 1e-12);
  }
}

TEST_CASE("an objective without turns is a clear error", "[axis-sweep]") {
  const RunRecord record =
      run_optimizer(*builtin_optimizers().make("axis-sweep"), test::CubeInPose(), {.budget = {.evaluations = 100}});
  REQUIRE(record.outcome == RunRecord::Outcome::kFailed);
  REQUIRE(record.error == "axis-sweep: 'cube in pose' has no best turns");
  REQUIRE(record.costs.evaluations() == 0);
}
