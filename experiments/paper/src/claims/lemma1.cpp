#include "claims/lemma1.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "claims/inequalities.h"

namespace rectilin::paper::claims {
namespace {

struct Interval {
  double begin = 0, length = 0;
};

/// The longest interval of gamma, the frame turning about its third axis, in which no face becomes
/// parallel to axis 1 or 2.
Interval longest_without_kinks(const AreaVectors& vectors, const Rotation& frame) {
  constexpr double kPeriod = std::numbers::pi / 2;
  std::vector<double> kinks;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const Vector3 v = frame.matrix() * vectors[i];
    const double angle = std::fmod(std::atan2(v.y(), v.x()) + 2 * std::numbers::pi, kPeriod);
    kinks.push_back(angle);
  }
  std::ranges::sort(kinks);
  Interval longest{kinks.back(), kinks.front() + kPeriod - kinks.back()};
  for (std::size_t i = 0; i + 1 < kinks.size(); ++i)
    if (kinks[i + 1] - kinks[i] > longest.length) longest = {kinks[i], kinks[i + 1] - kinks[i]};
  return longest;
}

Rotation turned_by(double gamma, const Rotation& frame) { return rotation_from_euler(0, 0, gamma) * frame; }

}  // namespace

Finding check_not_constant(const TestMesh& tested, Random random) {
  const Sampled greatest = greatest_ratio(*tested.objective, random, 100);
  return {greatest.ratio - tested.best.found, tested.source, nullptr, greatest.rotation, {}};
}

double second_difference_error(const ProjectedArea& objective, const Rotation& middle, double step) {
  const std::array<Rotation, 3> rotations{turned_by(-step, middle), middle, turned_by(step, middle)};
  std::array<double, 3> p{};
  objective.values(rotations, p);
  const Vector3 axis = middle.axis(2);
  double h = 0;
  FlatSum(objective.vectors()).values({&axis, 1}, {&h, 1});
  const double second = p[0] + p[2] - 2 * p[1];
  const double expected = -4 * std::pow(std::sin(step / 2), 2) * (p[1] - h / objective.vectors().total);
  return expected < 0 ? std::abs(second - expected) : std::numeric_limits<double>::infinity();
}

Finding check_second_difference(const TestMesh& tested, Random random) {
  const Rotation frame = random_rotation(random);
  const Interval interval = longest_without_kinks(tested.vectors(), frame);
  const Rotation middle = turned_by(interval.begin + interval.length / 2, frame);
  const double error = second_difference_error(*tested.objective, middle, 0.4 * interval.length);
  return {-error, tested.source, nullptr, middle, {}};
}

}  // namespace rectilin::paper::claims
