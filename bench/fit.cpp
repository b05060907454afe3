#include "fit.h"

#include <cmath>

namespace rectilin::bench {

double exponent(std::span<const Point> points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(points.size());
  for (const Point& p : points) {
    x += std::log(p.size) / n;
    y += std::log(p.time) / n;
  }
  for (const Point& p : points) {
    xx += (std::log(p.size) - x) * (std::log(p.size) - x);
    xy += (std::log(p.size) - x) * (std::log(p.time) - y);
  }
  return xy / xx;
}

}  // namespace rectilin::bench
