// A direction in the form in which the inner loops use it.
#pragma once

#include <algorithm>
#include <cmath>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// u . v = scale (a x + b y + z) with a = u_x / u_z, b = u_y / u_z and scale = u_z.
///
/// Dividing by u_z once per direction saves a multiplication per face: two multiply-adds are left
/// where u . v takes a multiplication and two multiply-adds. Multiplications can use only half of
/// the floating-point ports of current x86 cores, so they are what the loop waits for.
///
/// The rounding error of scale (a x + b y + z) is a few units in the last place of
/// |u_x x| + |u_y y| + |u_z z| <= |u| |v| however steep the slopes, as for u . v itself. Where u_z
/// is (nearly) zero it is moved away from zero by kTiny max |u_k|, which is far below that error.
template <class T>
struct Slope {
  T a, b;
};

template <class T>
inline constexpr double kTiny = 0x1p-300;  // slopes, hence sums, stay far below overflow
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

// The loops sum one side of the great circle only, the faces with a x + b y + z < 0; the total T of
// all v_i supplies the other: h(u) = u . T - 2 sum min(u . v_i, 0), and g(u) = T - 2 sum {v_i : u .
// v_i < 0}, for u_z > 0; -u stands for u where u_z < 0. Unlike an absolute value, a minimum runs on
// the ports of the additions and leaves those of the multiply-adds alone (Zen), and a cut needs no
// sign flips.

/// h(u) from `part` = sum min(a x + b y + z, 0). Zero at least, whatever the rounding.
inline double value_from_negative(const Vector3& total, const Vector3& u, double scale, double part) {
  return std::max(0.0, std::copysign(1.0, scale) * total.dot(u) - 2 * std::abs(scale) * part);
}

/// g(u) from `sum` = sum of v_i where a x + b y + z < 0.
inline Vector3 cut_from_negative(const Vector3& total, double scale, const Vector3& sum) {
  return std::copysign(1.0, scale) * (total - 2 * sum);
}

}  // namespace rectilin
