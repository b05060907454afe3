#include "reciprocal.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rectilin::search {
namespace {

constexpr double kLikeEnough = 2.0 / 3;  // a neighbour's neighbours join if so many of them are there already

std::vector<std::uint32_t> reciprocal(const Rankings& nearest, std::uint32_t i, std::size_t count) {
  const auto first = [&](std::uint32_t j) { return std::span(nearest[j]).first(std::min(count, nearest[j].size())); };
  std::vector<std::uint32_t> result;
  for (const std::uint32_t j : first(i))
    if (std::ranges::find(first(j), i) != first(j).end()) result.push_back(j);
  std::ranges::sort(result);
  return result;
}

}  // namespace

Rankings rankings(std::span<const float> distances, std::size_t size, std::size_t count) {
  count = std::min(count, size);
  Rankings result(size);
  std::vector<std::uint32_t> order(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    const auto row = distances.subspan(i * size, size);
    std::iota(order.begin(), order.end(), 0U);
    std::swap(order[0], order[i]);
    const auto from = order.begin() + 1, end = order.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(from, std::max(from, end), order.end(),
                      [&](std::uint32_t a, std::uint32_t b) { return std::pair(row[a], a) < std::pair(row[b], b); });
    result[i].assign(order.begin(), end);
  }
  return result;
}

std::vector<double> reciprocal_distances(std::span<const float> distances, std::size_t size,
                                         const ReciprocalOptions& options) {
  const std::size_t k = std::min(options.neighbours + 1, size);  // with itself
  const Rankings nearest = rankings(distances, size, std::max(k, options.expand));
  std::vector<std::vector<std::uint32_t>> full(size), half(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    full[i] = reciprocal(nearest, i, k);
    half[i] = reciprocal(nearest, i, std::min(options.neighbours / 2 + 1, size));
  }
  // A row for each shape: weights of what is near it, their sum 1.
  using Row = std::vector<std::pair<std::uint32_t, double>>;
  std::vector<Row> rows(size);
  std::vector<double> dense(size);
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<std::uint32_t> set = full[i], common;
    for (const std::uint32_t j : full[i]) {
      common.clear();
      std::ranges::set_intersection(half[j], full[i], std::back_inserter(common));
      if (static_cast<double>(common.size()) >= kLikeEnough * static_cast<double>(half[j].size()))
        set.insert(set.end(), half[j].begin(), half[j].end());
    }
    std::ranges::sort(set);
    set.erase(std::unique(set.begin(), set.end()), set.end());
    const double scale = std::max(static_cast<double>(distances[i * size + nearest[i][k - 1]]), 1e-9);
    double sum = 0;
    for (const std::uint32_t j : set) {
      rows[i].emplace_back(j, std::exp(-static_cast<double>(distances[i * size + j]) / scale));
      sum += rows[i].back().second;
    }
    for (auto& entry : rows[i]) entry.second /= sum;
  }
  const auto averaged = [&](std::size_t i) {
    const std::size_t count = std::min(std::max<std::size_t>(options.expand, 1), nearest[i].size());
    std::vector<double> sums(size);
    for (std::size_t m = 0; m < count; ++m)
      for (const auto& [j, weight] : rows[nearest[i][m]]) sums[j] += weight / static_cast<double>(count);
    return sums;
  };
  const std::vector<double> own = averaged(0);
  std::vector<double> result(size);
  for (std::size_t i = 1; i < size; ++i) {
    const std::vector<double> other = averaged(i);
    double shared = 0;
    for (std::size_t j = 0; j < size; ++j) shared += std::min(own[j], other[j]);
    result[i] = 1 - shared / (2 - shared);
  }
  return result;
}

}  // namespace rectilin::search
