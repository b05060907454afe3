// What optimizers minimise: a function of rotations.
//
// The objectives of this library have one form. A rotation Q has three rows q1, q2, q3, the axes of a frame, and
//
//     value(Q) = h(q1) + h(q2) + h(q3)
//
// with one function h that is even, convex and positively homogeneous of degree one. For a mesh h(u) is the sum of |u .
// v| over its area vectors v, and value(Q) is P/S. Everything else rests on two facts that follow.
//
// *Cuts.* A convex function lies above its tangents. With g_k a subgradient of h at q_k, the linear function
//
//     Q' -> g1 . q'1 + g2 . q'2 + g3 . q'3
//
// is nowhere above value(Q') and touches it at Q. So one evaluation says something about all rotations. Proofs are made
// of such cuts (certify.h), and gradient methods follow them.
//
// *Kinks.* h has a crease, or kink, wherever u is orthogonal to some v, that is where a face is parallel to an axis.
// Between kinks the objective is concave along turns, so every minimum lies on kinks: minima are sharp, and methods
// that need smooth functions work on the smooth surrogate below.
//
//     class Sum final : public Objective {        // of |entries|: least, 3, at the 24 rotations of the cube
//       std::string name() const override { return "sum"; }
//       void values(std::span<const Rotation> rotations, std::span<double> values) const override {
//         for (std::size_t i = 0; i < rotations.size(); ++i) values[i] = rotations[i].matrix().cwiseAbs().sum();
//       }
//     };
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "rectilin/base/rotation.h"

namespace rectilin {

/// A linear function below the objective: value(Q) >= (gradient . Q) for every rotation Q, where (A . Q) is the sum of
/// products of entries. It equals the objective at the rotation where the cut was taken.
///
/// An objective with cuts is a sum over the frame's axes, value(Q) = h(q1) + h(q2) + h(q3) with the rows q_k of Q and
/// one even, convex function h, positively homogeneous of degree one. Each row of the gradient is a subgradient of h:
/// h(u) >= row . u for every u. So a row that was taken for one axis is valid for the others as well.
struct Cut {
  double value = 0;          ///< the objective where the cut was taken
  Eigen::Matrix3d gradient;  ///< a subgradient with respect to the entries of the rotation matrix
};

/// The derivative of E -> (gradient . E R) at E = identity along turns about the three axes of the rotated frame:
/// moving R to rotation_from_vector(t) * R changes the linear form by (result . t), to first order.
inline Eigen::Vector3d turning_gradient(const Eigen::Matrix3d& gradient, const Rotation& at) {
  const Eigen::Matrix3d b = at.matrix() * gradient.transpose();
  return {b(1, 2) - b(2, 1), b(2, 0) - b(0, 2), b(0, 1) - b(1, 0)};
}

/// What a proof needs to know about rounding and size of an objective's cuts.
struct CutBounds {
  double error = 1e-12;  ///< h(u) >= row . u - error for unit u and rows of cuts; values err by at most 3 error
  double norm = 1;       ///< no row of a cut is longer
  double floor = 0;      ///< a general lower bound: no value is less, whatever the cuts say
};

/// The vectors v_i of an objective with h(u) = sum_i |u . v_i|: the generators of a zonotope, of which h is the support
/// function. For a mesh they are the area vectors of its faces. There are none if h is not of this kind.
struct Generators {
  std::span<const double> x = {}, y = {}, z = {};
  double scale = 1;  ///< factor of the components

  std::size_t size() const { return x.size(); }
  Eigen::Vector3d operator[](std::size_t i) const { return {scale * x[i], scale * y[i], scale * z[i]}; }
};

/// Value and gradient of a smooth function near the objective, at one rotation.
struct SmoothValue {
  double value = 0;
  Eigen::Matrix3d gradient;  ///< with respect to the entries of the rotation matrix
};

/// The best of all turns of a frame about one of its own axes.
struct BestTurn {
  Rotation rotation;
  double value = 0;  ///< the objective at that rotation
};

/// A function of rotations to be minimised. It is positive, and has the same value at D R as at R (see
/// frame_symmetries()). Implementations are immutable, safe to call from many threads, and give the same bits for any
/// number of threads.
class Objective {
 public:
  virtual ~Objective() = default;

  virtual std::string name() const = 0;

  /// values[i] = the objective at rotations[i]. A batch may be much cheaper than its rotations one by one: neighbours
  /// in it that have a row of the matrix in common, bit for bit, may share the work for that row.
  virtual void values(std::span<const Rotation> rotations, std::span<double> values) const = 0;

  /// The objective at one rotation.
  double value(const Rotation& rotation) const;

  /// Does the objective offer cuts? If not, cuts() must not be called.
  virtual bool has_cuts() const { return false; }
  virtual void cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) const;
  virtual CutBounds cut_bounds() const { return {}; }
  /// The vectors that h is made of, if it is a sum of absolute values; valid while the objective lives. Optional: with
  /// them proofs become tighter.
  virtual Generators generators() const { return {}; }

  /// Does the objective offer a smooth surrogate? If not, smooth() must not be called.
  virtual bool has_smooth() const { return false; }
  /// A smooth upper bound that tends to the objective as `width` (radians, > 0) goes to zero: a kink is rounded off
  /// where a face is within about `width` of being parallel to an axis.
  virtual SmoothValue smooth(const Rotation& rotation, double width) const;

  /// Can the objective be minimised exactly over the turns about one axis? If not, best_turn() must not be called.
  virtual bool has_turns() const { return false; }
  /// The exact minimum over the circle of frames that have axis k, k in {0, 1, 2}, in common with `rotation`.
  virtual BestTurn best_turn(const Rotation& rotation, int k) const;

  /// The number that people read, a decreasing function of the value: for a mesh the rectilinearity R(M).
  virtual double merit(double value) const { return -value; }
};

}  // namespace rectilin
