// Domains: boxes of three numbers that stand for rotations, such as Euler angles. Which domain is searched is a
// question for experiments, so optimizers are given one rather than having one built in.
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "rectilin/base/rotation.h"

namespace rectilin {

/// A box in R^3 and the map from it to rotations. Immutable and thread safe.
class Domain {
 public:
  virtual ~Domain() = default;

  virtual std::string_view name() const = 0;

  /// Opposite corners of the box.
  virtual Eigen::Vector3d lower() const = 0;
  virtual Eigen::Vector3d upper() const = 0;

  /// The rotation at `x`, which should lie in the box; the map is smooth beyond the box, too.
  virtual Rotation rotation(const Eigen::Vector3d& x) const = 0;

  /// A point of the box whose rotation has the same frame as `rotation` (up to frame_symmetries()). If the domain does
  /// not reach that frame: the point of the box that is nearest to one that would.
  virtual Eigen::Vector3d coordinates(const Rotation& rotation) const = 0;

  /// Does the box reach every frame?
  virtual bool covers() const = 0;

  /// The rotation at a point of the unit cube, which is stretched onto the box.
  Rotation from_unit(const Eigen::Vector3d& t) const { return rotation(lower() + t.cwiseProduct(upper() - lower())); }
};

/// The paper's search range [0, pi/2]^3 in the angles of eqs. (35)-(37), its eq. (28). It reaches only three quarters
/// of all frames: with alpha and beta in [0, pi/2] the third row always has the signs (+,-,+).
const Domain& paper_domain();

/// [0, pi] x [0, pi/2] x [0, pi/2] in the same angles: the smallest such box that reaches every frame. Why: the columns
/// of R are orthogonal, so sum_k R_k1 R_k2 = 0 over the three rows, hence some row has R_k1 R_k2 <= 0. Taken as the
/// third row, with the right sign, that row has alpha and beta in the box.
const Domain& covering_domain();

/// The cube |rho_i| <= sqrt(2)-1 of Rodrigues vectors around the cubic fundamental zone, which is the part of it with
/// |rho_1|+|rho_2|+|rho_3| <= 1. The zone holds each frame once; the eight corners outside it, 3.4 % of the cube's
/// volume, hold some frames a second time.
const Domain& zone_domain();

inline constexpr double kZoneHalfEdge = 0.41421356237309510;  ///< sqrt(2) - 1, rounded up

/// The domain "paper", "covering" or "zone"; throws ParameterError for any other name.
const Domain& domain_by_name(std::string_view name);

}  // namespace rectilin
