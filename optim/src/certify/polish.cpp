#include "polish.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "descent.h"

namespace rectilin::bounding {
namespace {

constexpr double kTolerances[] = {1e-4, 1e-6, 1e-8, 1e-10};  // radians to being parallel at the start
constexpr double kParallelInTheEnd = 1e-12;
constexpr int kDescent = 20, kNewtonSteps = 8;
constexpr double kIndependent = 0.1;  // sine of the angle between a condition and the span of those before

struct Condition {
  ActiveFace face;
  Eigen::Vector3d normal;  // unit
  double length;           // the generator's
};

/// All faces within `tolerance` of being parallel to an axis, the largest first.
std::vector<Condition> near_parallel(const Generators& generators, const Rotation& frame, double tolerance) {
  std::vector<Condition> found;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const Eigen::Vector3d v = generators[i];
    const double length = v.norm();
    for (int k = 0; k < 3; ++k)
      if (std::abs(frame.axis(k).dot(v)) <= tolerance * length) found.push_back({{k, i}, v / length, length});
  }
  std::ranges::stable_sort(found, std::ranges::greater(), &Condition::length);
  return found;
}

/// How r_k . n changes as the frame turns about the mesh's coordinate axes.
Eigen::Vector3d derivative(const Condition& c, const Rotation& frame) {
  return frame.axis(c.face.axis).cross(c.normal);
}

/// At most three conditions with independent derivatives, chosen greedily.
std::vector<Condition> independent(const std::vector<Condition>& conditions, const Rotation& frame) {
  std::vector<Condition> chosen;
  std::vector<Eigen::Vector3d> basis;
  for (const Condition& c : conditions) {
    Eigen::Vector3d rest = derivative(c, frame);
    for (const Eigen::Vector3d& b : basis) rest -= rest.dot(b) * b;
    if (rest.norm() < kIndependent) continue;
    chosen.push_back(c);
    basis.push_back(rest.normalized());
    if (chosen.size() == 3) break;
  }
  return chosen;
}

/// Newton's method; of several solutions of too few conditions the nearest one.
Rotation solve(const std::vector<Condition>& conditions, Rotation frame) {
  const auto count = static_cast<Eigen::Index>(conditions.size());
  for (int step = 0; step < kNewtonSteps; ++step) {
    Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 3, 3> a(count, 3);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> b(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Condition& c = conditions[static_cast<std::size_t>(i)];
      a.row(i) = derivative(c, frame).transpose();
      b[i] = -frame.axis(c.face.axis).dot(c.normal);
    }
    const Eigen::Vector3d turn = a.transpose() * (a * a.transpose()).fullPivLu().solve(b);
    frame = Rotation::from_quaternion((frame * rotation_from_vector(turn).inverse()).quaternion());
    if (turn.norm() < 1e-15) break;
  }
  return frame;
}

}  // namespace

std::vector<ActiveFace> polish(Evaluator& evaluator) {
  const Generators generators = evaluator.objective().generators();
  Rotation start = evaluator.incumbent().rotation;
  descend(evaluator, start, evaluator.cut(start), kDescent, 0);
  start = evaluator.incumbent().rotation;
  for (const double tolerance : kTolerances) {
    const std::vector<Condition> conditions = independent(near_parallel(generators, start, tolerance), start);
    if (!conditions.empty()) evaluator.value(solve(conditions, start));
  }
  const Rotation& end = evaluator.incumbent().rotation;
  std::vector<ActiveFace> active;
  for (const Condition& c : independent(near_parallel(generators, end, kParallelInTheEnd), end))
    active.push_back(c.face);
  return active;
}

}  // namespace rectilin::bounding
