// Zernike moments of pictures.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

namespace rectilin::retrieval {

using Picture = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  ///< rows from the top

/// Where a picture lies in the unit disk: pixel (column, row) has the coordinates ((column - x) / radius,
/// (y - row) / radius).
struct Disk {
  double x = 0, y = 0;
  double radius = 1;  ///< pixels
};

/// Zernike moments A_nm = (n+1)/pi integral f V*_nm over the unit disk (Khotanzad and Hong 1990, eq. 3), n = 0...10,
/// m = n, n-2, ... >= 0: 36 of them, in the order A_00, A_11, A_20, A_22, A_31, A_33, ... Their magnitudes do not
/// change when the picture is turned about the disk's centre or reflected.
///
/// The integral is a sum over pixels. V_nm is a polynomial of degree n in x and y, so all moments follow exactly from
/// the 66 moments of products of Legendre polynomials of total degree up to 10, which are two products of small
/// matrices and, other than moments of powers, do not cancel.
class ZernikeMoments {
 public:
  static constexpr int kOrder = 10;
  static constexpr int kCount = 36;

  /// All pixels that are not zero should lie in the disk.
  std::array<std::complex<double>, kCount> operator()(const Picture& picture, const Disk& disk) const;

  static const ZernikeMoments& instance();

 private:
  ZernikeMoments();
  Eigen::Matrix<std::complex<double>, kCount, (kOrder + 1) * (kOrder + 1)> from_legendre_;
};

/// V_nm(x, y) = R_nm(rho) exp(i m theta), for the sums above and for tests.
std::complex<double> zernike_polynomial(int n, int m, double x, double y);

}  // namespace rectilin::retrieval
