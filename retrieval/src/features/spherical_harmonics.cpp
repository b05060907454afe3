#include "features/spherical_harmonics.h"

#include <cmath>
#include <numbers>

namespace rectilin::retrieval {

HarmonicTransform::HarmonicTransform(int n, int bandwidth) : n_(n), bandwidth_(bandwidth) {
  constexpr double kPi = std::numbers::pi;
  std::vector<double> weight(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) {
    const double theta = kPi * (j + 0.5) / n;
    double sum = 1;
    for (int k = 1; k <= n / 2; ++k) sum -= 2 * std::cos(2 * k * theta) / (4.0 * k * k - 1);
    weight[static_cast<std::size_t>(j)] = 2.0 / n * sum;
  }
  for (int l = 0; l < bandwidth; ++l)
    for (int m = 0; m <= l; ++m)
      for (int j = 0; j < n; ++j)
        weighted_.push_back(std::sph_legendre(static_cast<unsigned>(l), static_cast<unsigned>(m), kPi * (j + 0.5) / n) *
                            weight[static_cast<std::size_t>(j)] * 2 * kPi / n);
  for (int m = 0; m < bandwidth; ++m)
    for (int k = 0; k < n; ++k) {
      cosine_.push_back(std::cos(2 * kPi * m * k / n));
      sine_.push_back(std::sin(2 * kPi * m * k / n));
    }
}

std::vector<double> HarmonicTransform::magnitudes(std::span<const double> values) const {
  const auto n = static_cast<std::size_t>(n_), bandwidth = static_cast<std::size_t>(bandwidth_);
  std::vector<double> result(size());
  std::vector<double> real(n), imaginary(n);
  for (std::size_t m = 0; m < bandwidth; ++m) {
    for (std::size_t j = 0; j < n; ++j) {
      real[j] = imaginary[j] = 0;
      for (std::size_t k = 0; k < n; ++k) {
        real[j] += values[j * n + k] * cosine_[m * n + k];
        imaginary[j] -= values[j * n + k] * sine_[m * n + k];
      }
    }
    for (std::size_t l = m; l < bandwidth; ++l) {
      const double* legendre = weighted_.data() + (l * (l + 1) / 2 + m) * n;
      double x = 0, y = 0;
      for (std::size_t j = 0; j < n; ++j) {
        x += legendre[j] * real[j];
        y += legendre[j] * imaginary[j];
      }
      result[l * (l + 1) / 2 + m] = std::hypot(x, y);
    }
  }
  return result;
}

}  // namespace rectilin::retrieval
