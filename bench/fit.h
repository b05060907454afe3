// Power laws.
#pragma once

#include <span>

namespace rectilin::bench {

struct Point {
  double size, time;
};

/// The exponent p of time ~ size^p (see power_law_exponent()), fitted to sizes from `least` on.
double exponent(std::span<const Point> points, double least = 0);

/// That of the tree is fitted from here on: below, the flat sum is as fast.
inline constexpr double kTreeFrom = 10'000;

}  // namespace rectilin::bench
