// Spherical harmonics of functions on the grid of radial_extent().
#pragma once

#include <span>
#include <vector>

namespace rectilin::retrieval {

/// |a_lm| for l < `bandwidth` and 0 <= m <= l, index l (l + 1) / 2 + m, of a real function on an n x n grid (see
/// radial_extent.h); a_lm = integral of f conj(Y_lm) with orthonormal Y_lm. Exact for functions of degree
/// below n - bandwidth: the sum over phi is, and over theta it is Fejer's first quadrature rule (Fejer 1933).
class HarmonicTransform {
 public:
  HarmonicTransform(int n, int bandwidth);
  std::vector<double> magnitudes(std::span<const double> values) const;
  std::size_t size() const { return static_cast<std::size_t>(bandwidth_ * (bandwidth_ + 1) / 2); }

 private:
  int n_, bandwidth_;
  std::vector<double> weighted_;       ///< [l (l+1)/2 + m][j]: Legendre function times quadrature weight
  std::vector<double> cosine_, sine_;  ///< [m][k], of m phi_k
};

}  // namespace rectilin::retrieval
