// The part of the sphere that an axis of the frame sweeps on a box of rotations.
#pragma once

#include "certify/box.h"
#include "certify/spherical_triangle.h"

namespace rectilin::bounding {

/// A polygon about it, with great circles for sides: x . side_i <= reach_i for every direction x the axis takes. Lemma 1
/// gives the reach.
class Sweep {
 public:
  Sweep(const Box& box, const Corners& corners, const Rotation& middle, int axis);

  /// About the radius, in radians; infinite if the polygon is not known to lie in a half-sphere.
  double radius() const { return radius_; }

  /// False if no direction in the triangle, mirrored if `mirror` is -1, lies in the polygon.
  bool may_meet(const Triangle3& p, double mirror) const;

  /// Is the unit vector in the polygon, but for rounding?
  bool holds(const Eigen::Vector3d& x) const {
    return x.dot(middle_) > 0 && (x[0] * side_[0] + x[1] * side_[1] + x[2] * side_[2] <= reach_).all();
  }

 private:
  Array8 side_[3];  // components; orthogonal to the direction in the middle
  Array8 reach_;
  Eigen::Vector3d middle_;
  double radius_;
};

}  // namespace rectilin::bounding
