// The statistics of comparing optimizers. Plain functions on samples, thread safe.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace rectilin::laboratory {

/// The p-quantile, 0 <= p <= 1, interpolated linearly between order statistics (type 7 of Hyndman and Fan
/// 1996). The sample must not be empty.
double quantile(std::vector<double> sample, double p);

inline double median(std::vector<double> sample) { return quantile(std::move(sample), 0.5); }

/// Ranks 1, 2, ... from the least; equal values share the mean of their ranks.
std::vector<double> ranks(std::span<const double> values);

/// The exponent p of y ~ x^p: the slope of the least-squares line through the logarithms. Both of one length, all
/// positive; NaN for fewer than two different x.
double power_law_exponent(std::span<const double> x, std::span<const double> y);

/// What it costs to reach a target if a run that missed it is followed by another (Hansen et al. 2021, section
/// "expected runtime"): all costs, of successes until the target and of failures until their end, over the
/// number of successes.
struct RunningTime {
  double cost = 0;
  std::size_t successes = 0;
  std::size_t runs = 0;

  /// A run that cost `to_target` until it reached the target, or `spent` in vain if `to_target` is infinite.
  void add(double to_target, double spent);

  double success_rate() const;  ///< NaN without runs
  double expected() const;      ///< infinite without a success
};

/// Wilcoxon's rank-sum test in the form of Mann and Whitney (1947), two-sided.
struct RankSum {
  double u = 0;            ///< pairs (x in a, y in b) with x > y; ties count one half
  double p = 1;            ///< exact for small samples without ties, else normal with both corrections
  double superiority = 0;  ///< chance that x < y for x of a, y of b, ties one half (Vargha and Delaney 2000)
};
/// Neither sample may be empty.
RankSum rank_sum(std::span<const double> a, std::span<const double> b);

/// p values corrected so that the chance of one false rejection among all is at most the level
/// (Holm 1979), in the order given.
std::vector<double> holm(std::span<const double> p);

}  // namespace rectilin::laboratory
