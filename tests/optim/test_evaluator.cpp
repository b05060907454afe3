#include <set>
#include <vector>

#include "rectilin/optim/evaluator.h"
#include "support/catch.h"
#include "support/frame_objective.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

std::vector<Rotation> some_rotations(int n) {
  Random random(1);
  std::vector<Rotation> rotations;
  for (int i = 0; i < n; ++i) rotations.push_back(random_rotation(random));
  return rotations;
}

}  // namespace

TEST_CASE("the evaluator stops at the budget, in the middle of a batch", "[evaluator]") {
  const test::CubeInPose cube;
  Evaluator evaluator(cube, {.evaluations = 7});
  const auto rotations = some_rotations(10);
  std::vector<double> values(10);
  evaluator.values(rotations, values);
  for (int i = 0; i < 10; ++i) REQUIRE(std::isfinite(values[i]) == (i < 7));
  REQUIRE(evaluator.exhausted());
  REQUIRE(evaluator.costs().evaluations() == 7);
  REQUIRE(std::isinf(evaluator.value(rotations[9])));
  REQUIRE(evaluator.costs().evaluations() == 7);
}

TEST_CASE("the incumbent is the best of all, and the trace its history", "[evaluator]") {
  const test::CubeInPose cube;
  Evaluator evaluator(cube);
  REQUIRE_FALSE(evaluator.has_incumbent());
  const auto rotations = some_rotations(200);
  std::vector<double> values(200);
  evaluator.values(rotations, values);
  const auto best = std::ranges::min_element(values);
  REQUIRE(evaluator.incumbent().value == *best);
  REQUIRE(evaluator.incumbent().rotation.matrix() == rotations[best - values.begin()].matrix());
  double previous = std::numeric_limits<double>::infinity();
  std::uint64_t at = 0;
  for (const TracePoint& point : evaluator.trace()) {
    REQUIRE(point.value < previous);
    REQUIRE(point.evaluations > at);
    REQUIRE(point.value == values[point.evaluations - 1]);
    previous = point.value, at = point.evaluations;
  }
  REQUIRE(evaluator.trace().front().evaluations == 1);
}

TEST_CASE("the digest tells runs apart", "[evaluator]") {
  const test::CubeInPose cube;
  const auto rotations = some_rotations(50);
  std::vector<double> values(50);
  Evaluator together(cube), single(cube), other(cube);
  together.values(rotations, values);
  for (const Rotation& r : rotations) single.value(r);
  for (const Rotation& r : rotations) other.value(r * rotations[3]);
  REQUIRE(together.digest() == single.digest());
  REQUIRE(together.digest() != other.digest());
}

TEST_CASE("the digest covers smooth values and turns", "[evaluator]") {
  const auto digest = [](const auto& ask) {
    Evaluator evaluator(test::pyramid());
    ask(evaluator);
    return evaluator.digest();
  };
  const Rotation at = some_rotations(1).front();
  const auto nothing = digest([](Evaluator&) {});
  const auto wide = digest([&](Evaluator& e) { e.smooth(at, 0.1); });
  const auto narrow = digest([&](Evaluator& e) { e.smooth(at, 0.01); });
  const auto turn = digest([&](Evaluator& e) {
    Rotation turned = at;
    e.turn(turned, 0);
  });
  REQUIRE(std::set{nothing, wide, narrow, turn}.size() == 4);
}

TEST_CASE("lower bounds only rise", "[evaluator]") {
  const test::CubeInPose cube;
  Evaluator evaluator(cube);
  evaluator.value(Rotation());
  REQUIRE_FALSE(evaluator.lower_bound());
  evaluator.raise_lower_bound(0.5);
  evaluator.raise_lower_bound(0.25);
  REQUIRE(*evaluator.lower_bound() == 0.5);
  REQUIRE(evaluator.trace().size() == 2);
  REQUIRE(evaluator.trace().back().lower == 0.5);
}

TEST_CASE("a stop and a time limit exhaust it", "[evaluator]") {
  const test::CubeInPose cube;
  std::stop_source stop;
  Evaluator stopped(cube, {}, stop.get_token());
  REQUIRE_FALSE(stopped.exhausted());
  stop.request_stop();
  REQUIRE(stopped.exhausted());
  Evaluator late(cube, {.seconds = 0});
  REQUIRE(late.exhausted());
}
