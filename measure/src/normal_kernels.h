// The layout of a normal tree, and what its driver (normal_tree.cpp) asks of its vector loops.
#pragma once

#include <cstddef>
#include <cstdint>

#include "flat_slope.h"
#include "flat_two_sum.h"

namespace rectilin {

/// Siblings are tested together: eight doubles fill one AVX-512 register, or a few narrower ones.
inline constexpr std::size_t kFan = 8;

/// Vectors of a leaf. Smaller leaves mean fewer vectors summed one by one, but more nodes.
inline constexpr std::size_t kLeaf = 8;

/// Doubles of a family of kFan siblings: x, y, z of their sums V, and |V| times the sine of their caps' radii
/// (infinite if a cap reaches a right angle).
inline constexpr std::size_t kFamily = 4 * kFan;
inline constexpr std::size_t kLeafSpan = 3 * kLeaf;

inline constexpr int kMaxLevels = 12;

/// Level 0 has the families of leaves; the highest level has one family.
struct NormalNodes {
  const double* leaves;
  const double* levels[kMaxLevels];
  int depth;
};

/// One direction's query.
struct NormalQuery {
  Slope<double> slope;
  double reach;       ///< |u| / scale: a cap of radius r meets the circle if |s| <= |V| sin(r) reach
  double resolution;  ///< squared sine of the smallest radius that is opened
};

/// Adds to sums[0] (values) or sums[0..2] (cuts) what FlatKernel's kNegative... see flat_kernels.h.
using NormalKernel = void (*)(const NormalNodes& nodes, const NormalQuery& query, TwoSum* sums);

struct NormalKernels {
  NormalKernel values, cuts;
  /// The square of the largest sine of an angle between v and any of `count` leaves' vectors; infinite if
  /// one of the angles is not acute.
  double (*cap)(const double* leaves, std::size_t count, const double* v);
};

const NormalKernels& normal_kernels();

}  // namespace rectilin
