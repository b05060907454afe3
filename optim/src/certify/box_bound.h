// The lower bound of a cut on a box of Rodrigues vectors: the core of the proof.
#pragma once

#include "certify/box.h"

namespace rectilin::certification {

/// A lower bound on the box of the linear form rotation -> (g . R), the sum of products of entries; `values` are the
/// form's values at the corners.
///
/// Multiplied by 1 + |rho|^2 the form is a quadratic polynomial. Let v be its least value at a corner, and subtract v
/// (1 + |rho|^2): the result is nonnegative at the corners, and along axis i its second derivative is 2 (N_ii - v),
/// where N_ii = 2 g_ii - tr g. If no N_ii exceeds v, it is concave along every edge, so its least value on the box is
/// at a corner, and v is the bound. An axis where N_ii exceeds v costs (N_ii - v) e_i^2, where e_i is half the edge.
/// (papers/certificate.md, lemma 1.)
///
/// The rounding error is at most kBoxRounding times the length of the longest row of g.
inline double box_bound(const Eigen::Matrix3d& g, const Array8& values, const Box& box) {
  const double least = values.minCoeff();
  const Eigen::Array3d excess = (2 * g.diagonal().array() - g.trace() - least).max(0);
  if (excess.maxCoeff() == 0) return least;
  return least - (excess * box.half_edges().array().square()).sum();
}

inline constexpr double kBoxRounding = 0x1p-44;

}  // namespace rectilin::certification
