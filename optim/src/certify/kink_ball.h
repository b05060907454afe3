// Balls of rotations around a sharp minimum that need no cells.
#pragma once

#include <vector>

#include "certify/box.h"
#include "rectilin/optim/objective.h"

namespace rectilin::certification {

/// The largest angle found such that the objective is at least `value` at every rotation within it of `centre`;
/// zero if there is none, as when the objective at `centre` is less than `value`.
///
/// Where faces are parallel to an axis of the frame their signs in a cut are free, and the directional derivative
/// is the support function of a zonotope. Its inradius is the rate at which the objective rises at least.
/// (papers/certificate.md, lemma 2.) An angle makes allowance for rounding of kBallRounding S.
double kink_ball(const Generators& generators, const Rotation& centre, double value);

inline constexpr double kBallRounding = 1e-11;

/// A set of balls, each with all its 24 copies that reach the zone.
class Balls {
 public:
  /// Takes a little less than the angle, for the rounding of quaternions and products.
  void add(const Rotation& centre, double angle);
  void clear() { balls_.clear(); }
  bool empty() const { return balls_.empty(); }

  /// Is the whole box in one of them?
  bool hold(const Box& box) const;

 private:
  struct Ball {
    Eigen::Vector4d quaternion;  // (w, x, y, z) of the centre
    double cosine;               // of half the angle
  };
  std::vector<Ball> balls_;
};

}  // namespace rectilin::certification
