#include "features/zernike.h"

#include <cmath>
#include <numbers>

namespace rectilin::retrieval {
namespace {

constexpr int kTerms = ZernikeMoments::kOrder + 1;
using LegendreValues = std::array<double, kTerms>;

LegendreValues legendre(double x) {
  LegendreValues p{1, x};
  for (std::size_t k = 1; k + 1 < kTerms; ++k) {
    const double n = static_cast<double>(k);
    p[k + 1] = ((2 * n + 1) * x * p[k] - n * p[k - 1]) / (n + 1);
  }
  return p;
}

/// Nodes and weights of the Gauss-Legendre rule that is exact to degree 2 kTerms + 1.
struct GaussRule {
  static constexpr int kNodes = kTerms + 1;
  std::array<double, kNodes> node, weight;
  GaussRule() {
    for (std::size_t i = 0; i < kNodes; ++i) {
      double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (kNodes + 0.5)), slope = 1;
      for (int step = 0; step < 50; ++step) {
        double before = 1, p = x;
        for (int k = 1; k < kNodes; ++k) {
          const double next = ((2 * k + 1) * x * p - k * before) / (k + 1);
          before = p;
          p = next;
        }
        slope = kNodes * (x * p - before) / (x * x - 1);
        x -= p / slope;
      }
      node[i] = x;
      weight[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

double factorial(int n) { return std::tgamma(n + 1.0); }

}  // namespace

std::complex<double> zernike_polynomial(int n, int m, double x, double y) {
  const double square = x * x + y * y;
  double radial = 0;  // R_nm / rho^m, in rho^2
  for (int s = 0; s <= (n - m) / 2; ++s)
    radial += (s % 2 == 0 ? 1 : -1) * factorial(n - s) /
              (factorial(s) * factorial((n + m) / 2 - s) * factorial((n - m) / 2 - s)) *
              std::pow(square, (n - m) / 2 - s);
  std::complex<double> turn = 1;  // (x + i y)^m = rho^m exp(i m theta)
  for (int k = 0; k < m; ++k) turn *= std::complex<double>(x, y);
  return radial * turn;
}

ZernikeMoments::ZernikeMoments() {
  // V*_nm = sum of c_pq P_p(x) P_q(y), c_pq = (2p+1)(2q+1)/4 times the integral of V*_nm P_p P_q over the square.
  from_legendre_.setZero();
  const GaussRule rule;
  int row = 0;
  for (int n = 0; n <= kOrder; ++n)
    for (int m = n % 2; m <= n; m += 2, ++row)
      for (std::size_t i = 0; i < GaussRule::kNodes; ++i)
        for (std::size_t j = 0; j < GaussRule::kNodes; ++j) {
          const double x = rule.node[i], y = rule.node[j];
          const std::complex<double> value = std::conj(zernike_polynomial(n, m, x, y)) * rule.weight[i] *
                                             rule.weight[j] * ((n + 1) / std::numbers::pi / 4);
          const LegendreValues px = legendre(x), py = legendre(y);
          for (int p = 0; p < kTerms; ++p)
            for (int q = 0; q < kTerms; ++q)
              from_legendre_(row, q * kTerms + p) +=
                  value *
                  ((2 * p + 1.0) * (2 * q + 1.0) * px[static_cast<std::size_t>(p)] * py[static_cast<std::size_t>(q)]);
        }
}

const ZernikeMoments& ZernikeMoments::instance() {
  static const ZernikeMoments moments;
  return moments;
}

std::array<std::complex<double>, ZernikeMoments::kCount> ZernikeMoments::operator()(const Picture& picture,
                                                                                    const Disk& disk) const {
  const auto table = [&](Eigen::Index count, double middle, double direction) {
    Eigen::Matrix<float, Eigen::Dynamic, kTerms> values(count, kTerms);
    for (Eigen::Index i = 0; i < count; ++i) {
      const LegendreValues p = legendre(direction * (static_cast<double>(i) - middle) / disk.radius);
      for (int k = 0; k < kTerms; ++k) values(i, k) = static_cast<float>(p[static_cast<std::size_t>(k)]);
    }
    return values;
  };
  const auto across = table(picture.cols(), disk.x, 1), down = table(picture.rows(), disk.y, -1);
  const Eigen::Matrix<float, Eigen::Dynamic, kTerms> rows = picture * across;
  const Eigen::Matrix<double, kTerms, kTerms> products =
      (down.transpose().cast<double>() * rows.cast<double>()) / (disk.radius * disk.radius);  // (q, p)
  std::array<std::complex<double>, kCount> moments;
  for (int k = 0; k < kCount; ++k) {
    std::complex<double> sum = 0;
    for (int q = 0; q < kTerms; ++q)
      for (int p = 0; p + q <= kOrder; ++p) sum += from_legendre_(k, q * kTerms + p) * products(q, p);
    moments[static_cast<std::size_t>(k)] = sum;
  }
  return moments;
}

}  // namespace rectilin::retrieval
