#include "rectilin/retrieval/significance.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "rectilin/base/random.h"

namespace rectilin::retrieval {
namespace {

constexpr std::size_t kDraws = 10'000;
constexpr std::size_t kExact = 12;  // classes with differences up to which all sign patterns are tried

struct Total {
  double sum = 0;
  double count = 0;
};

/// Sums by class, in the order of the classes' numbers.
std::vector<Total> totals(std::span<const double> values, std::span<const std::size_t> group) {
  std::map<std::size_t, Total> by_class;
  for (std::size_t i = 0; i < values.size(); ++i) {
    Total& total = by_class[group[i]];
    total.sum += values[i];
    total.count += 1;
  }
  std::vector<Total> list;
  for (const auto& [c, total] : by_class) list.push_back(total);
  return list;
}

Interval bootstrap(const std::vector<Total>& classes, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> means(kDraws);
  for (double& mean : means) {
    Total drawn;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      const Total& c = classes[random.below(classes.size())];
      drawn.sum += c.sum;
      drawn.count += c.count;
    }
    mean = drawn.sum / drawn.count;
  }
  std::ranges::sort(means);
  return {means[kDraws / 40], means[kDraws - 1 - kDraws / 40]};
}

double randomisation_p(const std::vector<Total>& classes, std::uint64_t seed) {
  std::vector<double> sums;
  double observed = 0, scale = 0;
  for (const Total& c : classes) {
    if (c.sum == 0) continue;
    sums.push_back(c.sum);
    observed += c.sum;
    scale += std::abs(c.sum);
  }
  const double threshold = std::abs(observed) - 1e-12 * scale;  // equal sums in another order count as equal
  const auto extreme = [&](auto sign) {
    double sum = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) sum += sign(i) ? -sums[i] : sums[i];
    return std::abs(sum) >= threshold;
  };
  std::size_t extremes = 0;
  if (sums.size() <= kExact) {
    const std::size_t patterns = std::size_t{1} << sums.size();
    for (std::size_t pattern = 0; pattern < patterns; ++pattern)
      extremes += extreme([&](std::size_t i) { return (pattern >> i & 1) != 0; });
    return static_cast<double>(extremes) / static_cast<double>(patterns);
  }
  Random random(seed);
  for (std::size_t draw = 0; draw < kDraws; ++draw)
    extremes += extreme([&](std::size_t) { return (random.bits() >> 63) != 0; });
  return static_cast<double>(extremes + 1) / static_cast<double>(kDraws + 1);  // what was observed is one of the draws
}

}  // namespace

PairedDifference paired_difference(std::span<const double> a, std::span<const double> b,
                                   std::span<const std::size_t> group, std::uint64_t seed) {
  std::vector<double> differences(a.size());
  PairedDifference result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    differences[i] = a[i] - b[i];
    result.mean += differences[i] / static_cast<double>(a.size());
  }
  const std::vector<Total> classes = totals(differences, group);
  const Interval interval = bootstrap(classes, seed);
  result.low = interval.low;
  result.high = interval.high;
  result.p = randomisation_p(classes, seed);
  return result;
}

Interval mean_interval(std::span<const double> values, std::span<const std::size_t> group, std::uint64_t seed) {
  return bootstrap(totals(values, group), seed);
}

}  // namespace rectilin::retrieval
