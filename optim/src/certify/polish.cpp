#include "certify/polish.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "certify/descent.h"
#include "certify/generator_kernels.h"

namespace rectilin::certification {
namespace {

constexpr double kPolishTolerances[] = {1e-4, 1e-6, 1e-8, 1e-10};  // radians from orthogonal at the start
constexpr double kPolishRadius = 1e-4;
constexpr int kPolishDescent = 20, kNewtonSteps = 8;
constexpr double kLastStep = 1e-8;    // radians; what is left after such a step is its square
constexpr double kIndependent = 0.1;  // least sine of the angle between a condition and the span of earlier ones

/// That a generator is orthogonal to an axis.
struct Condition {
  int axis;
  std::size_t generator;
  Eigen::Vector3d normal;                                // unit vector
  double length;                                         // length of the generator
  double error = 0;                                      // |r . normal| for the axis r of some frame
  Eigen::Vector3d derivative = Eigen::Vector3d::Zero();  // of r . normal as it turns about the mesh's coordinate axes

  void move_to(const Rotation& frame) {
    const Eigen::Vector3d r = frame.axis(axis);
    error = std::abs(r.dot(normal));
    derivative = r.cross(normal);
  }
};

/// The conditions that a frame meets within `tolerance` (radians).
std::vector<Condition> conditions_at(const Rotation& frame, const Generators& generators, double tolerance) {
  std::vector<Condition> conditions;
  for (const std::size_t i : split_at(frame.matrix(), generators, 1.001 * tolerance).near) {
    const Eigen::Vector3d v = generators[i], products = frame.matrix() * v;
    const double length = v.norm();
    for (int k = 0; k < 3; ++k) {
      if (!(std::abs(products[k]) <= tolerance * length)) continue;
      conditions.push_back({.axis = k, .generator = i, .normal = v / length, .length = length});
      conditions.back().move_to(frame);
    }
  }
  return conditions;
}

/// At most three conditions with independent derivatives: the one of the longest generator, then the longest that is
/// independent of it, then of both.
std::vector<Condition> independent(const std::vector<Condition>& conditions) {
  std::vector<Condition> chosen;
  std::vector<Eigen::Vector3d> basis;
  while (chosen.size() < 3) {
    const Condition* longest = nullptr;
    Eigen::Vector3d direction;
    for (const Condition& c : conditions) {
      if (longest && c.length <= longest->length) continue;
      Eigen::Vector3d rest = c.derivative;
      for (const Eigen::Vector3d& b : basis) rest -= rest.dot(b) * b;
      if (rest.squaredNorm() < kIndependent * kIndependent) continue;
      longest = &c;
      direction = rest.normalized();
    }
    if (!longest) break;
    chosen.push_back(*longest);
    basis.push_back(direction);
  }
  return chosen;
}

/// Newton's method; with fewer than three conditions, the minimum-norm step.
Rotation solve(std::vector<Condition> conditions, Rotation frame) {
  const auto count = static_cast<Eigen::Index>(conditions.size());
  for (int step = 0; step < kNewtonSteps; ++step) {
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> a(count, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> b(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      Condition& c = conditions[static_cast<std::size_t>(i)];
      c.move_to(frame);
      a.row(i) = c.derivative.transpose();
      b[i] = -frame.axis(c.axis).dot(c.normal);
    }
    const Eigen::Vector3d turn = a.transpose() * (a * a.transpose()).fullPivLu().solve(b);
    frame = Rotation::from_quaternion((frame * rotation_from_vector(turn).inverse()).quaternion());
    if (turn.norm() < kLastStep) break;
  }
  return frame;
}

}  // namespace

void polish(Evaluator& evaluator) {
  Rotation start = evaluator.incumbent().rotation;
  descend(evaluator, start, evaluator.cut(start), kPolishDescent, kPolishRadius, 0);
  start = evaluator.incumbent().rotation;
  const auto same = [](const Condition& a, const Condition& b) {
    return a.axis == b.axis && a.generator == b.generator;
  };
  const Generators generators = evaluator.objective().generators();
  std::vector<Condition> near = conditions_at(start, generators, kPolishTolerances[0]), before;
  for (const double tolerance : kPolishTolerances) {
    std::erase_if(near, [tolerance](const Condition& c) { return c.error > tolerance; });
    if (near.empty()) break;
    const std::vector<Condition> conditions = independent(near);
    if (!std::ranges::equal(conditions, before, same))
      evaluator.cut(solve(conditions, start));  // what sums cuts is there already
    before = conditions;
  }
}

}  // namespace rectilin::certification
