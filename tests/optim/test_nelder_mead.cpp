// Nelder and Mead's simplex on rotations, and what is built on it: multistart, hybrid.
#include "search/simplex.h"
#include "support/catch.h"
#include "support/frame_objective.h"
#include "support/known_shapes.h"

using namespace rectilin;

TEST_CASE("geodesics pass through their ends and move at constant speed", "[simplex]") {
  Random random(1);
  const Rotation a = random_rotation(random), b = random_rotation(random);
  const double angle = angle_between(a, b);
  REQUIRE(angle_between(along_geodesic(a, b, 0), a) < 1e-12);
  REQUIRE(angle_between(along_geodesic(a, b, 1), b) < 1e-12);
  REQUIRE(angle_between(a, along_geodesic(a, b, 0.25)) == Approx(angle / 4).margin(1e-12));
  REQUIRE(angle_between(b, along_geodesic(a, b, 0.25)) == Approx(angle * 3 / 4).margin(1e-12));
}

TEST_CASE("a nearest copy is the same frame, within the zone's radius", "[simplex]") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Rotation a = random_rotation(random), b = random_rotation(random);
    const Rotation copy = nearest_copy(a, b);
    REQUIRE(frame_angle(a, copy) < 1e-7);  // the angle of a rotation near the identity keeps half the digits
    REQUIRE(angle_between(copy, b) == Approx(frame_angle(a, b)).margin(1e-7));
  }
}

TEST_CASE("a simplex never loses its best vertex and contracts on a minimum", "[simplex]") {
  const test::CubeInPose cube;
  Evaluator evaluator(cube);
  Random random(3);
  Simplex simplex = Simplex::around(rotation_from_vector({0.1, 0.05, -0.1}), 0.2, evaluator, random);
  double previous = simplex.best().value;
  for (int i = 0; i < 300; ++i) {
    simplex.step(evaluator);
    REQUIRE(simplex.best().value <= previous);
    previous = simplex.best().value;
  }
  REQUIRE(simplex.radius() < 1e-6);
  REQUIRE(previous == Approx(1).margin(1e-6));
}

TEST_CASE("nelder-mead ends by itself at the pyramid's minimum", "[nelder-mead]") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RunRecord record = test::run_on_pyramid("nelder-mead", seed);
    REQUIRE(record.outcome == RunRecord::Outcome::kFinished);
    REQUIRE(record.costs.values < 2000);
    REQUIRE(record.merit == Approx(test::kPyramid).margin(1e-7));
  }
}

TEST_CASE("multistart runs any local method, and nothing else", "[multistart]") {
  REQUIRE(test::run_on_pyramid("multistart").merit == Approx(test::kPyramid).margin(1e-7));
  REQUIRE(test::run_on_pyramid("multistart?starts=0", 1, {.evaluations = 4321}).costs.values == 4321);
  const auto two = builtin_optimizers().make("multistart?local=nelder-mead?size=0.1,restarts=0&starts=2");
  REQUIRE(two->parameters() == Json{{"local", "nelder-mead?size=0.1,restarts=0"}, {"starts", 2}});
  REQUIRE_THROWS_WITH(builtin_optimizers().make("multistart?local=ga"), Catch::Contains("'ga' is not a local"));
  REQUIRE_THROWS_AS(builtin_optimizers().make("multistart?local=nelder-mead?size=-1"), ParameterError);
}

TEST_CASE("hybrid finds the pyramid's minimum from every seed", "[hybrid]") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    REQUIRE(test::run_on_pyramid("hybrid", seed).merit == Approx(test::kPyramid).margin(1e-7));
}
