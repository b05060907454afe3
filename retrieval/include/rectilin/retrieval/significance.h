// Is one way to compare shapes better than another, or was it luck with these models?
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rectilin::retrieval {

/// The mean of paired differences, with what it may be worth on other classes.
struct PairedDifference {
  double mean = 0;           ///< over the queries
  double low = 0, high = 0;  ///< 95 % interval: the bootstrap over classes, percentiles
  double p = 1;              ///< two-sided, of the randomisation test below
};

/// Compares two lists of scores of the same queries. Queries of one class resemble each other, so classes and not
/// queries are what is drawn at random: the test turns the sign of all differences of a class at once (Fisher's
/// randomisation test on class totals, Good 2005, section 3), and the interval comes from resampling whole classes
/// (the cluster bootstrap, Davison and Hinkley 1997, section 3.8). `group[i]` is the class of query i. The result is a
/// function of the arguments. Both lists and `group` are of one length, at least 1.
PairedDifference paired_difference(std::span<const double> a, std::span<const double> b,
                                   std::span<const std::size_t> group, std::uint64_t seed = 1);

/// 95 % interval of a mean over queries, by the same bootstrap.
struct Interval {
  double low = 0, high = 0;
};
Interval mean_interval(std::span<const double> values, std::span<const std::size_t> group, std::uint64_t seed = 1);

}  // namespace rectilin::retrieval
