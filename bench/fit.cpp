#include "fit.h"

#include <vector>

#include "rectilin/laboratory/statistics.h"

namespace rectilin::bench {

double exponent(std::span<const Point> points, double least) {
  std::vector<double> sizes, times;
  for (const Point& p : points) {
    if (p.size < least) continue;
    sizes.push_back(p.size);
    times.push_back(p.time);
  }
  return laboratory::power_law_exponent(sizes, times);
}

}  // namespace rectilin::bench
