// The part of the sphere that an axis of the frame sweeps on a box of rotations.
#pragma once

#include "certify/box.h"
#include "certify/spherical_triangle.h"

namespace rectilin::bounding {

/// An octagon about it with great circles for sides: where the axis points, its product with the outer normal of a side
/// is at most that side's reach. Lemma 1 gives the reach.
class Sweep {
 public:
  /// `middle` is the rotation in the box's centre. The octagon is wider than it need be by the fraction `wider`.
  Sweep(const Box& box, const Corners& corners, const Rotation& middle, int axis, double wider = 0);

  /// About the radius, in radians; infinite if the octagon is not known to be small.
  double radius() const { return radius_; }

  /// False if no direction in the triangle, mirrored if `mirror` is -1, lies in the octagon.
  bool may_meet(const Triangle3& p, double mirror) const;

  /// Is the unit vector in the octagon, but for rounding?
  bool holds(const Eigen::Vector3d& x) const;

 private:
  /// Products with four normals; the others are their opposites.
  Eigen::Array4d along(const Eigen::Vector3d& x) const;

  Eigen::Vector3d middle_, a_, b_;  // an orthonormal frame
  Eigen::Array4d most_, least_;     // of along(), on the octagon
  double radius_;
};

}  // namespace rectilin::bounding
