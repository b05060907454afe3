// What optimizers minimise: a function of rotations.
//
// The objectives of this library have one form. A rotation Q has three rows q1, q2, q3, the axes of a frame, and
//
//     value(Q) = h(q1) + h(q2) + h(q3)
//
// with one even, convex function h, positively homogeneous of degree one. For a mesh h(u) is the sum of |u . v| over
// its area vectors v, and value(Q) is P/S. Two facts follow, on which everything else rests.
//
// *Cuts.* A convex function lies above its tangents. With g_k a subgradient of h at q_k, the linear function
//
//     Q' -> g1 . q'1 + g2 . q'2 + g3 . q'3
//
// is nowhere above value(Q') and touches it at Q: one evaluation says something about all rotations. That is what
// proofs are made of (certify.h), and what gradient methods follow.
//
// *Kinks.* h has a crease wherever u is orthogonal to some v, that is where a face is parallel to an axis. Between
// creases the objective bends downwards along turns, so every minimum lies on them: minima are sharp, and smooth
// methods need the smooth surrogate below.
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

/// A linear minorant: value(Q) >= (gradient . Q) for every rotation Q, where (A . Q) is the sum of products
/// of entries, with equality at the rotation the cut was taken at.
///
/// An objective with cuts is a sum over the frame's axes, value(Q) = h(q1) + h(q2) + h(q3) with q_k the rows of Q and
/// one even, convex function h, positively homogeneous of degree one. Each row of the gradient is a subgradient of h:
/// h(u) >= row . u for every u. So a row taken for one axis serves the others, too.
struct Cut {
  double value = 0;          ///< the objective where the cut was taken
  Eigen::Matrix3d gradient;  ///< a subgradient with respect to the entries of the rotation matrix
};

/// Derivative of E -> (gradient . E R) at E = identity, along turns about the three coordinate axes of
/// the rotated frame: moving R to rotation_from_vector(t) * R changes the linear form by (result . t) to
/// first order.
inline Eigen::Vector3d turning_gradient(const Eigen::Matrix3d& gradient, const Rotation& at) {
  const Eigen::Matrix3d b = at.matrix() * gradient.transpose();
  return {b(1, 2) - b(2, 1), b(2, 0) - b(0, 2), b(0, 1) - b(1, 0)};
}

/// What else a proof of the objective's minimum rests on.
struct CutBounds {
  double error = 1e-12;  ///< h(u) >= row . u - error for every unit u and row of a cut; values err by 3 error at most
  double norm = 1;       ///< no row is longer
  double floor = 0;      ///< no value is less, whatever the cuts say
};

/// Vectors v_i that make up h: h(u) = sum_i |u . v_i|, a zonotope's support function. None if h is not of that kind.
struct Generators {
  std::span<const double> x = {}, y = {}, z = {};
  double scale = 1;  ///< of the components

  std::size_t size() const { return x.size(); }
  Eigen::Vector3d operator[](std::size_t i) const { return {scale * x[i], scale * y[i], scale * z[i]}; }
};

/// A smooth function near the objective, at one rotation.
struct SmoothValue {
  double value = 0;
  Eigen::Matrix3d gradient;  ///< with respect to the entries of the rotation matrix
};

/// The best of all turns of a frame about one of its own axes.
struct BestTurn {
  Rotation rotation;
  double value = 0;  ///< the objective there
};

/// A function of rotations to minimise; positive, and the same for D R as for R (frame_symmetries()).
/// Implementations are immutable and safe to call from many threads, and give the same bits for any
/// number of threads.
class Objective {
 public:
  virtual ~Objective() = default;

  virtual std::string name() const = 0;

  /// values[i] = the objective at rotations[i]. A batch may be much cheaper than its parts; neighbours
  /// in it that share a row of the matrix, bit for bit, may share that row's work.
  virtual void values(std::span<const Rotation> rotations, std::span<double> values) const = 0;

  /// The objective at one rotation.
  double value(const Rotation& rotation) const;

  /// Can it give cuts? If not, cuts() must not be called.
  virtual bool has_cuts() const { return false; }
  virtual void cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) const;
  virtual CutBounds cut_bounds() const { return {}; }
  /// Valid while the objective lives. Optional; makes proofs tighter.
  virtual Generators generators() const { return {}; }

  /// Can it give a smooth surrogate? If not, smooth() must not be called.
  virtual bool has_smooth() const { return false; }
  /// A smooth upper bound that tends to the objective as `width` (radians, > 0) goes to zero: kinks are
  /// rounded off where a face is within about `width` of being parallel to an axis.
  virtual SmoothValue smooth(const Rotation& rotation, double width) const;

  /// Can it minimise exactly over the turns about one axis? If not, best_turn() must not be called.
  virtual bool has_turns() const { return false; }
  /// The global minimum over the circle of frames that share axis k, k in {0, 1, 2}, with `rotation`.
  virtual BestTurn best_turn(const Rotation& rotation, int k) const;

  /// The figure people read, a decreasing function of the value: the rectilinearity R(M) for a mesh.
  virtual double merit(double value) const { return -value; }
};

}  // namespace rectilin
