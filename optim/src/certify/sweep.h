// The part of the sphere that an axis of the frame sweeps on a box of rotations.
#pragma once

#include <numbers>

#include "certify/box.h"
#include "rectilin/base/rotation.h"

namespace rectilin::certification {

/// An octagon about it with great circles for sides: where the axis points, its product with the outer normal of a side
/// is at most that side's reach. Lemma 1 gives the reach.
class Sweep {
 public:
  /// `middle` is the rotation in the box's centre. The octagon is wider than it need be by the fraction `wider`.
  Sweep(const Box& box, const Corners& corners, const Rotation& middle, int axis, double wider = 0);

  /// About the radius, in radians; infinite if the octagon is not known to be small.
  double radius() const { return radius_; }

  /// Where a point is: its products with four normals, whose opposites are the other four, and with the middle.
  struct Place {
    Eigen::Array4d sides;
    double ahead;
  };
  Place place(const Eigen::Vector3d& x) const {
    constexpr double kHalf = std::numbers::sqrt2 / 2;
    const double a = x.dot(a_), b = x.dot(b_);
    return {{a, b, kHalf * (a + b), kHalf * (a - b)}, x.dot(middle_)};
  }

  /// False if no direction in a triangle with corners there, mirrored if `mirror` is -1, lies in the octagon. (A
  /// triangle misses the half-sphere x . n <= s, s >= 0, if its corners do: at a point sum a_j p_j the a_j >= 0 add up
  /// to at least 1.)
  bool may_meet(const Place& p, const Place& q, const Place& r, double mirror) const {
    const Eigen::Array4d low = p.sides.min(q.sides).min(r.sides), high = p.sides.max(q.sides).max(r.sides);
    if (mirror > 0)
      return (low <= most_ + kRounding).all() && (high >= least_ - kRounding).all() &&
             std::max({p.ahead, q.ahead, r.ahead}) >= -kRounding;
    return (low <= kRounding - least_).all() && (high >= -most_ - kRounding).all() &&
           std::min({p.ahead, q.ahead, r.ahead}) <= kRounding;
  }

  /// Is the unit vector in the octagon, but for rounding?
  bool holds(const Eigen::Vector3d& x) const {
    const Place at = place(x);
    return at.ahead > 0 && (at.sides >= least_).all() && (at.sides <= most_).all();
  }

 private:
  static constexpr double kRounding = 1e-12;  // of a reach, and of products of unit vectors, amply

  Eigen::Vector3d middle_, a_, b_;  // an orthonormal frame
  Eigen::Array4d most_, least_;     // of the four products, on the octagon
  double radius_;
};

}  // namespace rectilin::certification
