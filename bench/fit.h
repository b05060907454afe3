// Power laws.
#pragma once

#include <span>

namespace rectilin::bench {

struct Point {
  double size, time;
};

/// The exponent p of time ~ size^p, see power_law_exponent().
double exponent(std::span<const Point> points);

}  // namespace rectilin::bench
