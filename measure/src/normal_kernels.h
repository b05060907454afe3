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

/// Doubles of a family of kFan siblings: x, y, z of their sums V, kFan each, then |V| sin(radius of
/// the cap), which is infinite if a cap reaches a right angle. Missing siblings have V = 0 and
/// radius -1: they never open.
inline constexpr std::size_t kFamily = 4 * kFan;

/// Doubles of a leaf: x, y, z of its vectors, kLeaf each. Missing vectors are zero.
inline constexpr std::size_t kLeafSpan = 3 * kLeaf;

inline constexpr int kMaxLevels = 12;  // enough for 2^36 vectors

/// Nodes of one level that a query opens at most.
inline constexpr std::size_t kMostOpened = 16384;

/// Node j of family f on level l is the parent of family 8 f + j on level l - 1, or of leaf 8 f + j
/// if l = 0. The highest level is a single family.
struct NormalNodes {
  const double* leaves = nullptr;
  const double* levels[kMaxLevels] = {};
  /// Nodes of each level that a query may open before it gives up; at most kMostOpened.
  std::size_t limits[kMaxLevels] = {};
  int depth = 0;  ///< number of levels
};

struct NormalQuery {
  Slope<double> slope;
  double reach;  ///< |u| / |scale|: the circle meets a cap of radius r if |s| <= |V| sin(r) reach
  double resolution;  ///< squared sine of the radius up to which a node is not opened
};

/// Adds the sums over the nodes of one query: of min(s, 0) to sums[0], or of V where s < 0 to
/// sums[0..2]. False if the query gave up.
using NormalKernel = bool (*)(const NormalNodes& nodes, const NormalQuery& query, TwoSum* sums);

struct NormalKernels {
  NormalKernel values, cuts;
  /// Squared sine of the largest angle between the unit vector `axis` and the vectors of `count`
  /// leaves; infinite if an angle is not acute, or a vector too short to tell.
  double (*cap)(const double* leaves, std::size_t count, const double* axis);
};

const NormalKernels& normal_kernels();

}  // namespace rectilin
