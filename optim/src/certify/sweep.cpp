#include "certify/sweep.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "certify/box_bound.h"

namespace rectilin::certification {
namespace {

constexpr double kWidest = 0.7;  // reach of octagons worth looking at

}  // namespace

Sweep::Sweep(const Box& box, const Corners& corners, const Rotation& middle, int axis, double wider)
    : middle_(middle.axis(axis)), a_(middle.axis((axis + 1) % 3)), b_(middle.axis((axis + 2) % 3)) {
  const auto least = [&](const Eigen::Vector3d& direction) {
    Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
    form.row(axis) = direction.transpose();
    return box_bound(form, corners.along(axis, direction), box) - kRounding;
  };
  constexpr double kHalf = std::numbers::sqrt2 / 2;
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

}  // namespace rectilin::certification
