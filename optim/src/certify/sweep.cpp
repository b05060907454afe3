#include "certify/sweep.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "certify/box_bound.h"

namespace rectilin::bounding {
namespace {

constexpr double kRounding = 1e-12;  // of a reach, and of products of unit vectors, amply
constexpr double kWidest = 0.7;      // reach of octagons worth looking at
constexpr double kHalf = std::numbers::sqrt2 / 2;

}  // namespace

Sweep::Sweep(const Box& box, const Corners& corners, const Rotation& middle, int axis, double wider)
    : middle_(middle.axis(axis)), a_(middle.axis((axis + 1) % 3)), b_(middle.axis((axis + 2) % 3)) {
  const auto least = [&](const Eigen::Vector3d& direction) {
    Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
    form.row(axis) = direction.transpose();
    return box_bound(form, corners.along(axis, direction), box) - kRounding;
  };
  const std::array<Eigen::Vector3d, 4> normals = {a_, b_, kHalf * (a_ + b_), kHalf * (a_ - b_)};
  for (int i = 0; i < 4; ++i) {
    most_[i] = std::max(0.0, -least(-normals[i]));
    least_[i] = std::min(0.0, least(normals[i]));
  }
  most_ *= 1 + wider;
  least_ *= 1 + wider;
  radius_ = std::max(most_.maxCoeff(), -least_.minCoeff());
  if (radius_ > kWidest || least(middle_) < 0) radius_ = std::numeric_limits<double>::infinity();
}

Eigen::Array4d Sweep::along(const Eigen::Vector3d& x) const {
  const double a = x.dot(a_), b = x.dot(b_);
  return {a, b, kHalf * (a + b), kHalf * (a - b)};
}

bool Sweep::holds(const Eigen::Vector3d& x) const {
  const Eigen::Array4d products = along(x);
  return x.dot(middle_) > 0 && (products >= least_).all() && (products <= most_).all();
}

// A triangle misses the half-sphere x . n <= s, s >= 0, if its corners do: at a point sum a_j p_j the a_j >= 0 add up
// to at least 1.
bool Sweep::may_meet(const Triangle3& p, double mirror) const {
  const Eigen::Array4d first = along(p[0]), second = along(p[1]), third = along(p[2]);
  const Eigen::Array4d low = first.min(second).min(third), high = first.max(second).max(third);
  if (mirror > 0) {
    if ((low > most_ + kRounding).any() || (high < least_ - kRounding).any()) return false;
  } else {
    if ((low > kRounding - least_).any() || (high < -most_ - kRounding).any()) return false;
  }
  // Not if it is behind.
  return std::max({mirror * p[0].dot(middle_), mirror * p[1].dot(middle_), mirror * p[2].dot(middle_)}) >= -kRounding;
}

}  // namespace rectilin::bounding
