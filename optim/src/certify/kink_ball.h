// Balls of rotations around a sharp minimum in which nothing is better, so that no cells are needed there.
#pragma once

#include <vector>

#include "certify/box.h"
#include "rectilin/optim/objective.h"

namespace rectilin::certification {

/// The largest angle found such that the objective is at least `value` at every rotation within it of `centre`; zero if
/// there is none, for instance because the objective at `centre` is less than `value`.
///
/// Where a face is parallel to an axis of the frame, its sign in a cut is free, and the directional derivative of the
/// objective is the support function of a zonotope. The radius of the largest ball in that zonotope is the rate at
/// which the objective rises at least (papers/certificate.md, lemma 2). The angle allows for rounding errors of
/// kBallRounding S.
double kink_ball(const Generators& generators, const Rotation& centre, double value);

inline constexpr double kBallRounding = 1e-11;

/// A set of balls, each with those of its 24 copies that reach the zone.
class Balls {
 public:
  /// Adds a ball, a little smaller than the angle says, for the rounding of quaternions and products.
  void add(const Rotation& centre, double angle);
  void clear() { balls_.clear(); }
  bool empty() const { return balls_.empty(); }

  /// Does one of the balls hold the whole box?
  bool hold(const Box& box) const;

 private:
  struct Ball {
    Eigen::Vector4d quaternion;  // the centre as (w, x, y, z)
    double cosine;               // cosine of half the angle
  };
  std::vector<Ball> balls_;
};

}  // namespace rectilin::certification
