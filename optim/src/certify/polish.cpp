#include "certify/polish.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "certify/descent.h"
#include "certify/generator_kernels.h"

namespace rectilin::certification {
namespace {

constexpr double kPolishTolerances[] = {1e-4, 1e-6, 1e-8, 1e-10};  // radians from orthogonal at the start
constexpr double kParallelInTheEnd = 1e-12;
constexpr double kPolishRadius = 1e-4;
constexpr int kPolishDescent = 20, kNewtonSteps = 8;
constexpr double kIndependent = 0.1;  // least sine of the angle between a condition and the span of earlier ones

struct Condition {
  ActiveGenerator face;
  Eigen::Vector3d normal;  // unit vector
  double length;           // length of the generator
};

/// The derivative of r_k . n as the frame turns about the mesh's coordinate axes.
Eigen::Vector3d derivative(const Condition& c, const Rotation& frame) {
  return frame.axis(c.face.axis).cross(c.normal);
}

/// The generators that are nearly orthogonal to an axis, for all frames near a central one. There may be millions of
/// generators, so all of them are looked at only when the centre moves.
class Neighbourhood {
 public:
  Neighbourhood(const Generators& generators, const Rotation& centre) : generators_(generators) { move_to(centre); }

  /// At most three conditions within `tolerance` (radians) of being met, with independent derivatives: the longest,
  /// then the longest that is independent of it, then of both.
  std::vector<Condition> independent(const Rotation& frame, double tolerance) {
    if (angle_between(centre_, frame) + tolerance > kReach) move_to(frame);
    std::vector<Condition> chosen;
    std::vector<Eigen::Vector3d> basis;
    while (chosen.size() < 3) {
      const Condition* longest = nullptr;
      Eigen::Vector3d direction;
      for (const Condition& c : near_) {
        if ((longest && c.length <= longest->length) || std::abs(frame.axis(c.face.axis).dot(c.normal)) > tolerance)
          continue;
        Eigen::Vector3d rest = derivative(c, frame);
        for (const Eigen::Vector3d& b : basis) rest -= rest.dot(b) * b;
        if (rest.norm() < kIndependent) continue;
        longest = &c;
        direction = rest.normalized();
      }
      if (!longest) break;
      chosen.push_back(*longest);
      basis.push_back(direction);
    }
    return chosen;
  }

 private:
  static constexpr double kReach = 3e-4;  // radians

  void move_to(const Rotation& frame) {
    centre_ = frame;
    near_.clear();
    for (const std::size_t i : split_at(frame.matrix(), generators_, 1.001 * kReach).near) {
      const Eigen::Vector3d v = generators_[i], products = frame.matrix() * v;
      const double length = v.norm();
      for (int k = 0; k < 3; ++k)
        if (std::abs(products[k]) <= kReach * length) near_.push_back({{k, i}, v / length, length});
    }
  }

  Generators generators_;
  Rotation centre_;
  std::vector<Condition> near_;  // those within kReach for the central frame
};

/// Newton's method; with fewer than three conditions, the minimum-norm step.
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

std::vector<ActiveGenerator> polish(Evaluator& evaluator) {
  Rotation start = evaluator.incumbent().rotation;
  descend(evaluator, start, evaluator.cut(start), kPolishDescent, kPolishRadius, 0);
  start = evaluator.incumbent().rotation;
  Neighbourhood faces(evaluator.objective().generators(), start);
  std::vector<Condition> before;
  for (const double tolerance : kPolishTolerances) {
    std::vector<Condition> conditions = faces.independent(start, tolerance);
    if (conditions.empty()) break;  // so it is for a smaller tolerance
    if (!std::ranges::equal(conditions, before, {}, &Condition::face, &Condition::face))
      evaluator.cut(solve(conditions, start));  // what sums cuts is there already
    before = std::move(conditions);
  }
  const Rotation& end = evaluator.incumbent().rotation;
  std::vector<ActiveGenerator> active;
  for (const Condition& c : faces.independent(end, kParallelInTheEnd)) active.push_back(c.face);
  return active;
}

}  // namespace rectilin::certification
