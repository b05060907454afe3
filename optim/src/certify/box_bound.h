// The bound on a box of Rodrigues vectors: the heart of the certificate.
#pragma once

#include "certify/box.h"

namespace rectilin::certification {

/// A number that the linear form rotation -> (g . R), the sum of products of entries, does not fall below on
/// the box; `values` are those of the form at the corners.
///
/// Times 1 + |rho|^2 the form is a quadratic polynomial. Less v (1 + |rho|^2), v its least value at a corner, it
/// is nonnegative at the corners, and along axis i its second derivative is 2 (N_ii - v), where N_ii = 2 g_ii - tr g.
/// If no N_ii exceeds v, it is concave along every edge, so its least value over the box is at a corner, and v is
/// the bound. An axis where N_ii exceeds v costs (N_ii - v) e_i^2, e_i half the edge. (papers/certificate.md, lemma 1.)
///
/// Rounding is at most kBoxRounding times the largest |row of g|.
inline double box_bound(const Eigen::Matrix3d& g, const Array8& values, const Box& box) {
  const double least = values.minCoeff();
  const Eigen::Array3d excess = (2 * g.diagonal().array() - g.trace() - least).max(0);
  if (excess.maxCoeff() == 0) return least;
  return least - (excess * box.half_edges().array().square()).sum();
}

inline constexpr double kBoxRounding = 0x1p-44;

}  // namespace rectilin::certification
