#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

/// Remembers what it is asked for.
class Listener final : public Objective {
 public:
  std::string name() const override { return "listener"; }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override {
    heard.insert(heard.end(), rotations.begin(), rotations.end());
    std::ranges::fill(values, 1.0);
  }
  mutable std::vector<Rotation> heard;
};

std::vector<Rotation> asked_by(const std::string& spec) {
  const Listener listener;
  run_optimizer(*builtin_optimizers().make(spec), listener, {});
  return listener.heard;
}

double nearest_pair(const std::vector<Rotation>& rotations) {
  double least = 4;
  for (std::size_t i = 0; i < rotations.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, angle_between(rotations[i], rotations[j]));
  return least;
}

}  // namespace

TEST_CASE("both samplers cover rotations uniformly", "[sampling]") {
  for (const char* spec : {"random?evaluations=20000", "super-fibonacci?count=20000"}) {
    INFO(spec);
    const auto rotations = asked_by(spec);
    REQUIRE(rotations.size() == 20000);
    // Under the invariant measure every entry of R has mean 0 and mean square 1/3.
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero(), square = mean;
    for (const Rotation& r : rotations) mean += r.matrix(), square += r.matrix().cwiseAbs2();
    REQUIRE((mean / 20000).cwiseAbs().maxCoeff() < 0.02);  // five standard deviations of random ones
    REQUIRE(((square / 20000).array() - 1.0 / 3).abs().maxCoeff() < 0.011);
  }
}

TEST_CASE("super-Fibonacci points keep apart, random ones do not", "[sampling]") {
  const auto even = asked_by("super-fibonacci?count=1000"), random = asked_by("random?evaluations=1000");
  REQUIRE(even.size() == 1000);
  // A thousand balls that fill the group have a radius of 0.27 radians.
  REQUIRE(nearest_pair(even) > 0.1);
  REQUIRE(nearest_pair(random) < 0.1);
}

TEST_CASE("samplers spend the budget, or 10,000 evaluations without one", "[sampling]") {
  for (const char* spec : {"random", "super-fibonacci"}) {
    REQUIRE(test::run_on_pyramid(spec).costs.values == 10000);
    REQUIRE(test::run_on_pyramid(spec, 1, {.evaluations = 12345}).costs.values == 12345);
  }
  REQUIRE(test::run_on_pyramid("random?evaluations=77", 1, {.evaluations = 12345}).costs.values == 77);
}
