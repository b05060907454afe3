// Power laws.
#pragma once

#include <span>

namespace rectilin::bench {

struct Point {
  double size, time;
};

/// The exponent p of time ~ size^p: the slope of the least-squares line through the logarithms. NaN
/// for fewer than two sizes.
double exponent(std::span<const Point> points);

}  // namespace rectilin::bench
