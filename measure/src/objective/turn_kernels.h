// What the best turn (best_turn.cpp) asks of its vector loop (turn_kernels.cpp).
#pragma once

#include <cstdint>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// The view along an axis of a frame: (first . v, -second . v), turned by right angles into the
/// first quadrant.
struct QuadrantView {
  Vector3 first, second;
  double buckets;  ///< parts the quadrant is divided into

  /// Where in the quadrant (x, y), x, y >= 0, points: from 0 to 1 as the angle goes from 0 to pi/2,
  /// and without its arc tangent. 0 for the zero vector.
  static double place(double x, double y) { return y / std::max(x + y, kLeast); }

  static constexpr double kLeast = 0x1p-1000;
};

/// x[i], y[i]: the view of face i; bucket[i]: the whole part of buckets * place(x[i], y[i]), less
/// than buckets. On the best instruction set that is present and not ruled out by
/// ScopedInstructionSet.
void view_faces(const FaceSpan<double>& faces, const QuadrantView& view, double* x, double* y, std::int32_t* bucket);

}  // namespace rectilin
