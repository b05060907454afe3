#include "rectilin/laboratory/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rectilin::laboratory {
namespace {

/// Indices that put the values in order.
std::vector<std::size_t> order_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  return order;
}

/// Sizes of the groups of equal values.
std::vector<double> tie_groups(std::vector<double> values) {
  std::ranges::sort(values);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && values[i] == values[i - 1]) ++sizes.back();
    else sizes.push_back(1);
  }
  return sizes;
}

/// P(U <= u) if both samples come from one distribution without ties. The number of arrangements of m and n
/// values with a given U is that for (m - 1, n), where the largest is one of the m, shifted by n, plus
/// that for (m, n - 1) (Mann and Whitney 1947, eq. 4).
double exact_lower_tail(std::size_t m, std::size_t n, std::size_t u) {
  std::vector<std::vector<double>> chance(n + 1);  // chance[j][w]: of U = w for (i, j), i growing
  for (auto& row : chance) row.assign(m * n + 1, 0.0);
  for (auto& row : chance) row[0] = 1;  // i = 0
  for (std::size_t i = 1; i <= m; ++i) {
    for (std::size_t j = 1; j <= n; ++j) {
      const double share = static_cast<double>(i) / static_cast<double>(i + j);
      for (std::size_t w = m * n + 1; w-- > 0;) {
        const double largest_is_ours = w >= j ? chance[j][w - j] : 0.0;
        chance[j][w] = share * largest_is_ours + (1 - share) * chance[j - 1][w];
      }
    }
  }
  return std::accumulate(chance[n].begin(), chance[n].begin() + static_cast<std::ptrdiff_t>(u) + 1, 0.0);
}

constexpr std::size_t kExact = 25;  ///< largest sample for which the exact distribution is tabulated

double two_sided_p(double u, std::size_t m, std::size_t n, const std::vector<double>& ties) {
  const double pairs = static_cast<double>(m * n), total = static_cast<double>(m + n);
  const double smaller = std::min(u, pairs - u);
  const bool tied = ties.size() < m + n;
  if (!tied && m <= kExact && n <= kExact)
    return std::min(1.0, 2 * exact_lower_tail(m, n, static_cast<std::size_t>(smaller)));
  double correction = 0;
  for (const double t : ties) correction += t * t * t - t;
  const double variance = pairs / 12 * (total + 1 - correction / (total * (total - 1)));
  if (variance <= 0) return 1;  // all values are equal
  const double z = std::max(0.0, pairs / 2 - smaller - 0.5) / std::sqrt(variance);
  return std::erfc(z / std::sqrt(2.0));
}

}  // namespace

double quantile(std::vector<double> sample, double p) {
  std::ranges::sort(sample);
  const double place = p * static_cast<double>(sample.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sample.size() - 1);
  const double weight = place - static_cast<double>(below);
  if (weight == 0 || sample[below] == sample[above]) return sample[below];  // also if both are infinite
  return (1 - weight) * sample[below] + weight * sample[above];
}

std::vector<double> ranks(std::span<const double> values) {
  const std::vector<std::size_t> order = order_of(values);
  std::vector<double> result(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) result[order[i]] = static_cast<double>(begin + 1 + end) / 2;
    begin = end;
  }
  return result;
}

double power_law_exponent(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    xy += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
  }
  return xy / xx;
}

void RunningTime::add(double to_target, double spent) {
  const bool reached = std::isfinite(to_target);
  cost += reached ? to_target : spent;
  successes += reached;
  ++runs;
}

double RunningTime::success_rate() const {
  if (runs == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(successes) / static_cast<double>(runs);
}

double RunningTime::expected() const {
  if (successes == 0) return std::numeric_limits<double>::infinity();
  return cost / static_cast<double>(successes);
}

RankSum rank_sum(std::span<const double> a, std::span<const double> b) {
  std::vector<double> both(a.begin(), a.end());
  both.insert(both.end(), b.begin(), b.end());
  const std::vector<double> rank = ranks(both);
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  const double sum = std::accumulate(rank.begin(), rank.begin() + static_cast<std::ptrdiff_t>(a.size()), 0.0);
  RankSum result;
  result.u = sum - m * (m + 1) / 2;
  result.p = two_sided_p(result.u, a.size(), b.size(), tie_groups(both));
  result.superiority = 1 - result.u / (m * n);
  return result;
}

std::vector<double> holm(std::span<const double> p) {
  std::vector<double> corrected(p.size());
  double largest = 0;
  std::size_t left = p.size();
  for (const std::size_t i : order_of(p)) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(left--) * p[i]));
    corrected[i] = largest;
  }
  return corrected;
}

}  // namespace rectilin::laboratory
