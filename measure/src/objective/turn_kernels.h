// The interface between the best turn (best_turn.cpp) and its vector loop (turn_kernels.cpp).
#pragma once

#include <cstdint>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// How vectors look along an axis of a frame: (first . v, -second . v), turned by right angles into the first quadrant.
struct QuadrantView {
  Vector3 first, second;
  double buckets;  ///< number of parts that the quadrant is divided into

  /// Where (x, y), x, y >= 0, lies in the quadrant: from 0 to 1 as the angle goes from 0 to pi/2, though not in
  /// proportion to it, which saves an arc tangent. 0 for the zero vector.
  static double place(double x, double y) { return y / std::max(x + y, kLeast); }

  static constexpr double kLeast = 0x1p-1000;
};

/// Writes the view of vector i to x[i], y[i], and to bucket[i] the whole part of buckets * place(x[i], y[i]), which is
/// less than buckets. Uses the best instruction set of the processor that ScopedInstructionSet allows.
void view_vectors(const VectorSpan<double>& faces, const QuadrantView& view, double* x, double* y,
                  std::int32_t* bucket);

}  // namespace rectilin
