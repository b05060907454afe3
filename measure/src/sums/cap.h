// Caps: small discs on the sphere that hold the directions of some vectors, for sums that look at vectors one by one
// only where the great circle u . v = 0 meets their cap.
#pragma once

#include <cmath>

namespace rectilin {

/// |V| sin(r) for the cap of radius r around V that holds vectors whose largest squared sine to V is given; infinite if
/// that is. The circle of u meets the cap if |u . V| < |u| |V| sin(r).
///
/// A generous allowance for rounding is added. A larger error would be harmless, too: a vector that is misjudged
/// because of rounding lies so close to the great circle that its u . v is itself no larger than a rounding error.
inline double cap_radius(double length, double squared_sine) {
  constexpr double kSlack = 0x1p-36;
  const double sine = std::sqrt(squared_sine);
  return std::isinf(sine) ? sine : length * (sine + kSlack);
}

}  // namespace rectilin
