#include "features/fourier.h"

#include <cmath>
#include <numbers>

namespace rectilin::retrieval {

std::vector<double> centroid_distances(std::span<const Pixel> contour, double x, double y) {
  std::vector<double> distances;
  distances.reserve(contour.size());
  for (const Pixel& p : contour) distances.push_back(std::sqrt((p.x - x) * (p.x - x) + (p.y - y) * (p.y - y)));
  return distances;
}

std::vector<double> fourier_descriptors(std::span<const double> values, int count) {
  std::vector<double> result(static_cast<std::size_t>(count));
  double mean = 0;
  for (const double v : values) mean += v;
  if (!(mean > 0)) return result;
  const double n = static_cast<double>(values.size());
  for (int k = 1; k <= count; ++k) {
    const double angle = -2 * std::numbers::pi * k / n;
    const std::complex<double> step(std::cos(angle), std::sin(angle));
    std::complex<double> turn = 1, sum = 0;
    for (const double v : values) {
      sum += v * turn;
      turn = {turn.real() * step.real() - turn.imag() * step.imag(),
              turn.real() * step.imag() + turn.imag() * step.real()};
    }
    result[static_cast<std::size_t>(k - 1)] = std::abs(sum) / mean;
  }
  return result;
}

}  // namespace rectilin::retrieval
