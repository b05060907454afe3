// The optimizers that are other libraries': NLopt, Ceres, pagmo.
#include "support/catch.h"
#include "support/frame_objective.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

std::vector<std::string> family(const std::string& prefix) {
  std::vector<std::string> names;
  for (const auto& entry : all_optimizers().entries())
    if (entry.name.starts_with(prefix)) names.push_back(entry.name);
  return names;
}

}  // namespace

TEST_CASE("global methods of the libraries come near the pyramid's minimum", "[nlopt][pagmo]") {
  for (const std::string prefix : {"nlopt:G", "pagmo:"})
    for (const std::string& name : family(prefix)) {
      if (all_optimizers().make(name)->capabilities().local) continue;
      INFO(name);
      double best = 0;
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
        best = std::max(best, test::run_on_pyramid(name, seed, {.evaluations = 10000}).merit);
      REQUIRE(best > test::kPyramid - 0.03);  // as many random rotations come within 0.04 to 0.05
    }
}

TEST_CASE("gradient methods reach a minimum through the smooth surrogate", "[nlopt][ceres]") {
  std::vector<std::string> names = family("nlopt:LD");
  names.push_back("ceres?starts=1");
  for (const std::string& name : names) {
    INFO(name);
    const RunRecord record = test::run_on_pyramid("super-fibonacci?count=500+" + name);
    REQUIRE(record.costs.smooths > 0);
    REQUIRE(record.costs.values > 500);                            // the objective itself, at the ends of the rounds
    REQUIRE(record.merit == Approx(test::kPyramid).margin(1e-5));  // the last width is 1e-6
  }
}

TEST_CASE("gradient methods name the objective that has no surrogate", "[nlopt][ceres]") {
  for (const char* name : {"nlopt:LD_LBFGS", "nlopt:GD_STOGO", "nlopt:G_MLSL?local=LD_SLSQP", "ceres"}) {
    const RunRecord record = run_optimizer(*all_optimizers().make(name), test::CubeInPose(), {});
    REQUIRE(record.outcome == RunRecord::Outcome::kFailed);
    REQUIRE_THAT(record.error, Catch::EndsWith("'cube in pose' has no smooth surrogate"));
  }
}

TEST_CASE("MLSL takes the local method it is given", "[nlopt]") {
  REQUIRE(test::run_on_pyramid("nlopt:G_MLSL?local=LN_SBPLX").costs.smooths == 0);
  REQUIRE(test::run_on_pyramid("nlopt:G_MLSL?local=LD_LBFGS").costs.smooths > 0);
  REQUIRE_THROWS_AS(all_optimizers().make("nlopt:G_MLSL?local=GN_DIRECT"), ParameterError);
}

TEST_CASE("a box method on the paper's domain stays in that box", "[nlopt][pagmo]") {
  for (const std::string name : {"nlopt:GN_CRS2_LM", "nlopt:LN_SBPLX", "nlopt:LD_LBFGS"}) {
    const RunRecord record = test::run_on_pyramid(name, 1, {.evaluations = 500}, paper_domain());
    const Eigen::Vector3d x = paper_domain().coordinates(record.incumbent.rotation);
    REQUIRE(frame_angle(paper_domain().rotation(x), record.incumbent.rotation) < 1e-7);
  }
}

TEST_CASE("pagmo is as large as it is told to be", "[pagmo]") {
  if (family("pagmo:").empty()) {
    WARN("built without pagmo");
    return;
  }
  // The first population and its generations, then the next population.
  const RunRecord record = test::run_on_pyramid("pagmo:sga?population=10&generations=3&evaluations=95");
  REQUIRE(record.costs.values == 95);
  REQUIRE_THROWS_AS(all_optimizers().make("pagmo:sga?population=1"), ParameterError);
}
