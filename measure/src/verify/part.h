// Boxes of Rodrigues vectors, and bounds of linear forms on them, as the verifier computes them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>

namespace rectilin::verification {

/// A box of Rodrigues vectors rho; the rotation is ((1 - |rho|^2) I + 2 rho rho^T + 2 [rho]x) / (1 + |rho|^2).
struct Part {
  Eigen::Vector3d low, high;

  Part half(int axis, bool upper) const {
    Part part = *this;
    (upper ? part.low : part.high)[axis] = 0.5 * (low[axis] + high[axis]);
    return part;
  }

  int longest() const {
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  /// The least |rho|_1 in the box exceeds 1.
  bool outside_zone() const {
    long double sum = 0;
    for (int i = 0; i < 3; ++i) sum += std::max({0.0, low[i], -high[i]});
    return sum > 1;
  }
};

/// A number that sum_k g_k . r_k(rho), g_k the rows of g, does not fall below on the box, but for rounding. Multiplied
/// by 1 + |rho|^2 and less a bound times that it is a polynomial, quadratic in each coordinate, that is nonnegative if
/// its Bernstein coefficients on the box are. Those are the values of its polar form, where x^2 becomes low^2, low *
/// high or high^2 and x their mean. (That of 1 + |rho|^2 is positive: the products are at least -0.18.)
inline double least_on(const Eigen::Matrix3d& g, const Part& part) {
  const double trace = g.trace();
  const Eigen::Vector3d linear(g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1));
  double least = std::numeric_limits<double>::infinity();
  for (int index = 0; index < 27; ++index) {
    const std::array<int, 3> digit = {index % 3, index / 3 % 3, index / 9};
    double x[3], square[3], norm = 1;
    for (int i = 0; i < 3; ++i) {
      const double a = digit[i] == 2 ? part.high[i] : part.low[i], b = digit[i] == 0 ? part.low[i] : part.high[i];
      x[i] = 0.5 * (a + b);
      square[i] = a * b;
      norm += square[i];
    }
    double coefficient = trace;
    for (int i = 0; i < 3; ++i) {
      coefficient += 2 * linear[i] * x[i] + (2 * g(i, i) - trace) * square[i];
      for (int j = 0; j < i; ++j) coefficient += 2 * (g(i, j) + g(j, i)) * x[i] * x[j];
    }
    least = std::min(least, coefficient / norm);
  }
  return least;
}

}  // namespace rectilin::verification
