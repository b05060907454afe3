// Boxes of Rodrigues vectors, the cells of the search, and the rotations at their corners.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "rectilin/optim/domain.h"

namespace rectilin::certification {

/// A number for each corner of a box. Bit i of the corner's index says which end it has on axis i.
using Array8 = Eigen::Array<double, 8, 1>;

/// -1 or 1 by the end that each corner has on an axis.
inline const std::array<Array8, 3> kCornerSigns = [] {
  std::array<Array8, 3> signs;
  for (int axis = 0; axis < 3; ++axis)
    for (int c = 0; c < 8; ++c) signs[axis][c] = (c >> axis) % 2 == 0 ? -1 : 1;
  return signs;
}();

struct Box {
  Eigen::Vector3d lower, upper;

  /// The cube about the cubic fundamental zone: it holds every frame (see zone_domain()).
  static Box zone() { return {Eigen::Vector3d::Constant(-kZoneHalfEdge), Eigen::Vector3d::Constant(kZoneHalfEdge)}; }

  Eigen::Vector3d centre() const { return 0.5 * (lower + upper); }
  Eigen::Vector3d half_edges() const { return 0.5 * (upper - lower); }

  /// The lower (0) or upper (1) half across an axis. Both halves share the middle bit for bit, so no rounding
  /// opens a gap between them.
  Box half(int axis, int side) const {
    Box box = *this;
    (side == 0 ? box.upper : box.lower)[axis] = 0.5 * (lower[axis] + upper[axis]);
    return box;
  }

  /// Might it hold a point of the zone, |rho|_1 <= 1? The margin is for the rounding of the sum.
  bool meets_zone() const { return lower.cwiseMax(-upper).cwiseMax(0).sum() <= 1 + 1e-15; }

  Array8 coordinate(int axis) const {
    Array8 x;
    for (int c = 0; c < 8; ++c) x[c] = ((c >> axis) % 2 == 0 ? lower : upper)[axis];
    return x;
  }
};

/// The eight corners side by side: coordinates, 1 + |rho|^2, and the entries of the rotation matrices, row by row.
struct Corners {
  explicit Corners(const Box& box) {
    for (int i = 0; i < 3; ++i) rho[i] = box.coordinate(i);
    const auto& [x, y, z] = rho;
    const Array8 xx = x * x, yy = y * y, zz = z * z;
    norm = 1 + xx + yy + zz;
    const Array8 once = norm.inverse(), twice = 2 * once;
    entry[0] = (1 + xx - yy - zz) * once;
    entry[4] = (1 - xx + yy - zz) * once;
    entry[8] = (1 - xx - yy + zz) * once;
    entry[1] = (x * y - z) * twice;
    entry[3] = (x * y + z) * twice;
    entry[2] = (x * z + y) * twice;
    entry[6] = (x * z - y) * twice;
    entry[5] = (y * z - x) * twice;
    entry[7] = (y * z + x) * twice;
  }

  /// The linear function `slope` of row k, at every corner.
  Array8 along(int k, const Eigen::Vector3d& slope) const {
    return slope[0] * entry[3 * k] + slope[1] * entry[3 * k + 1] + slope[2] * entry[3 * k + 2];
  }

  std::array<Array8, 3> rho;
  Array8 norm;
  std::array<Array8, 9> entry;
};

}  // namespace rectilin::certification
