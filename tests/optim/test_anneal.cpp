#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;

TEST_CASE("annealing comes to the pyramid's minimum with each cooling", "[anneal]") {
  for (const char* spec : {"anneal", "anneal?cooling=fast", "anneal?cooling=boltzmann", "anneal?reheat=best"}) {
    INFO(spec);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      REQUIRE(test::run_on_pyramid(spec, seed).merit == Approx(test::kPyramid).margin(1e-4));
  }
  // A straight line leaves only its very end to the fine search.
  REQUIRE(test::run_on_pyramid("anneal?cooling=linear").merit == Approx(test::kPyramid).margin(0.01));
}

TEST_CASE("annealing does not depend on the scale of the objective", "[anneal]") {
  class Scaled final : public Objective {
    std::string name() const override { return "scaled"; }
    void values(std::span<const Rotation> rotations, std::span<double> values) const override {
      test::pyramid().values(rotations, values);
      for (double& value : values) value *= 1024;  // a power of two: the same bits but for the exponent
    }
  };
  const RunRecord once = test::run_on_pyramid("anneal");
  const RunRecord scaled = run_optimizer(*builtin_optimizers().make("anneal"), Scaled(), {});
  REQUIRE(scaled.incumbent.rotation.matrix() == once.incumbent.rotation.matrix());
}

TEST_CASE("annealing takes a share of a budget if it is told to", "[anneal]") {
  REQUIRE(test::run_on_pyramid("anneal?evaluations=3000", 1, {.evaluations = 5000}).costs.values == 3000);
  REQUIRE_THROWS_AS(builtin_optimizers().make("anneal?hot=1e-6&cold=1e-3"), ParameterError);
}
