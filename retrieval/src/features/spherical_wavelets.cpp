#include "features/spherical_wavelets.h"

#include <cmath>

namespace rectilin::retrieval {

SphericalWavelets::SphericalWavelets(const render::ViewSphere& sphere) : sphere_(sphere), areas_(sphere.size()) {
  // On the finest level every vertex stands for as much; on a coarser one also for half of each middle of its edges.
  const auto levels = static_cast<std::size_t>(sphere.level()) + 1;
  by_level_.resize(levels);
  by_level_.back().assign(sphere.size(), 1 / static_cast<double>(sphere.size()));
  for (std::size_t level = levels; level-- > 1;) {
    const std::size_t begin = begin_of(static_cast<int>(level));
    const std::vector<double>& fine = by_level_[level];
    std::vector<double>& coarse = by_level_[level - 1];
    coarse.assign(fine.begin(), fine.begin() + static_cast<std::ptrdiff_t>(begin));
    for (std::size_t m = begin; m < fine.size(); ++m)
      for (const std::uint32_t end : sphere.edges()[m - 6]) coarse[end] += fine[m] / 2;
  }
  for (std::size_t level = 0; level < levels; ++level)
    for (std::size_t k = begin_of(static_cast<int>(level)); k < by_level_[level].size(); ++k)
      areas_[k] = by_level_[level][k];
}

std::size_t SphericalWavelets::begin_of(int level) const {
  return level == 0 ? 0 : (std::size_t{4} << (2 * (level - 1))) + 2;
}

std::vector<double> SphericalWavelets::coefficients(std::vector<double> values) const {
  for (int level = sphere_.level(); level > 0; --level) {
    const std::vector<double>&fine = by_level_[static_cast<std::size_t>(level)],
          &coarse = by_level_[static_cast<std::size_t>(level) - 1];
    for (std::size_t m = begin_of(level); m < fine.size(); ++m) {
      const auto [a, b] = sphere_.edges()[m - 6];
      values[m] -= (values[a] + values[b]) / 2;
    }
    for (std::size_t m = begin_of(level); m < fine.size(); ++m)
      for (const std::uint32_t end : sphere_.edges()[m - 6]) values[end] += values[m] * fine[m] / (2 * coarse[end]);
  }
  for (std::size_t k = 0; k < values.size(); ++k) values[k] *= std::sqrt(areas_[k]);
  return values;
}

std::vector<double> SphericalWavelets::values(std::vector<double> coefficients) const {
  for (std::size_t k = 0; k < coefficients.size(); ++k) coefficients[k] /= std::sqrt(areas_[k]);
  for (int level = 1; level <= sphere_.level(); ++level) {
    const std::vector<double>&fine = by_level_[static_cast<std::size_t>(level)],
          &coarse = by_level_[static_cast<std::size_t>(level) - 1];
    for (std::size_t m = begin_of(level); m < fine.size(); ++m)
      for (const std::uint32_t end : sphere_.edges()[m - 6])
        coefficients[end] -= coefficients[m] * fine[m] / (2 * coarse[end]);
    for (std::size_t m = begin_of(level); m < fine.size(); ++m) {
      const auto [a, b] = sphere_.edges()[m - 6];
      coefficients[m] += (coefficients[a] + coefficients[b]) / 2;
    }
  }
  return coefficients;
}

}  // namespace rectilin::retrieval
