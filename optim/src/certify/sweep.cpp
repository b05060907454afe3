#include "certify/sweep.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "certify/box_bound.h"

namespace rectilin::bounding {
namespace {

constexpr double kRounding = 1e-12;  // of a reach, and of products of unit vectors, amply
constexpr double kWidest = 0.7;      // reach of polygons worth looking at

}  // namespace

Sweep::Sweep(const Box& box, const Corners& corners, const Rotation& middle, int axis) : middle_(middle.axis(axis)) {
  const Eigen::Vector3d a = middle.axis((axis + 1) % 3), b = middle.axis((axis + 2) % 3);
  const auto least = [&](const Eigen::Vector3d& direction) {
    Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
    form.row(axis) = direction.transpose();
    return box_bound(form, corners.along(axis, direction), box) - kRounding;
  };
  for (int i = 0; i < 8; ++i) {
    static constexpr double kHalf = std::numbers::sqrt2 / 2;
    static constexpr double kCosine[] = {1, kHalf, 0, -kHalf, -1, -kHalf, 0, kHalf};
    const Eigen::Vector3d side = kCosine[i] * a + kCosine[(i + 6) % 8] * b;
    for (int j = 0; j < 3; ++j) side_[j][i] = side[j];
    reach_[i] = std::max(0.0, -least(-side));
  }
  radius_ = reach_.maxCoeff();
  if (radius_ > kWidest || least(middle_) < 0) radius_ = std::numeric_limits<double>::infinity();
}

// A triangle misses a half-sphere x . n <= s, s >= 0, if its corners do: at a point sum a_j p_j the a_j >= 0 add up to
// at least 1.
bool Sweep::may_meet(const Triangle3& p, double mirror) const {
  bool behind = true;
  Array8 nearest = Array8::Constant(std::numeric_limits<double>::infinity());
  for (int j = 0; j < 3; ++j) {
    const Eigen::Vector3d corner = mirror * p[j];
    behind = behind && corner.dot(middle_) < -kRounding;
    nearest = nearest.min(corner[0] * side_[0] + corner[1] * side_[1] + corner[2] * side_[2]);
  }
  return !behind && !(nearest > reach_ + kRounding).any();
}

}  // namespace rectilin::bounding
