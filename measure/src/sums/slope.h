// A direction in the form that the inner loops use.
#pragma once

#include <algorithm>
#include <cmath>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// u . v = scale (a x + b y + z) with a = u_x / u_z, b = u_y / u_z and scale = u_z.
///
/// Dividing by u_z once for each direction saves a multiplication for each vector: two multiply-adds are left, where u
/// . v takes a multiplication and two multiply-adds. Only half of the floating-point ports of current x86 cores can
/// multiply, so multiplications are what the loop waits for.
///
/// The rounding error of scale (a x + b y + z) is a few units in the last place of |u_x x| + |u_y y| + |u_z z| <= |u|
/// |v|, however steep the slopes, as it is for u . v itself. Where u_z is (nearly) zero it is moved away from zero by
/// kTiny max |u_k|, which is far below that error.
template <class T>
struct Slope {
  T a, b;
};

template <class T>
inline constexpr double kTiny =
    0x1p-300;  // small enough not to matter, large enough that slopes and sums do not overflow
template <>
inline constexpr double kTiny<float> = 0x1p-40;

/// The divisor u_z of a direction's slopes; zero only for the zero vector.
template <class T>
double slope_scale(const Vector3& u) {
  const double least = kTiny<T> * u.cwiseAbs().maxCoeff();
  return std::copysign(std::max(std::abs(u.z()), least), u.z());
}

template <class T>
Slope<T> slope(const Vector3& u, double scale) {
  if (scale == 0) return {};
  return {static_cast<T>(u.x() / scale), static_cast<T>(u.y() / scale)};
}

// The loops sum only one side of the great circle, the vectors with a x + b y + z < 0. The total T of all v_i supplies
// the other side: for u_z > 0, h(u) = u . T - 2 sum min(u . v_i, 0) and g(u) = T - 2 sum {v_i : u . v_i < 0}; where u_z
// < 0, -u takes the place of u. Unlike an absolute value, a minimum runs on the ports of the additions and leaves those
// of the multiply-adds alone (Zen), and a cut needs no changes of sign.

/// h(u) from `part` = sum min(a x + b y + z, 0). Never below zero, whatever the rounding.
inline double value_from_negative(const Vector3& total, const Vector3& u, double scale, double part) {
  return std::max(0.0, std::copysign(1.0, scale) * total.dot(u) - 2 * std::abs(scale) * part);
}

/// g(u) from `sum` = sum of v_i where a x + b y + z < 0.
inline Vector3 cut_from_negative(const Vector3& total, double scale, const Vector3& sum) {
  return std::copysign(1.0, scale) * (total - 2 * sum);
}

}  // namespace rectilin
