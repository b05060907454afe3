// The layout of a direction tree, and what its driver (direction_tree.cpp) asks of its vector loops.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sums/slope.h"
#include "sums/two_sum.h"

namespace rectilin {

/// Siblings are tested together: eight doubles fill one AVX-512 register, or a few narrower ones.
inline constexpr std::size_t kFan = 8;

/// Vectors of a leaf. Smaller leaves mean fewer vectors summed one by one, but more nodes.
inline constexpr std::size_t kLeaf = 8;

/// kFan siblings in three cache lines: their sums V, component by component, and caps around them.
/// What a query of a large tree costs is the number of cache lines it reads, so the caps take no
/// room of their own: the last byte of each component holds a byte of the cap's |V| sin(radius), a
/// double without its sign and without the lower 39 bits, rounded up. A sum lacks 2^-44 of itself
/// by that. The radius is infinite if the cap reaches a right angle. Missing siblings are all
/// zeros.
struct alignas(64) NormalFamily {
  std::uint64_t sums[3][kFan];
};
static_assert(sizeof(NormalFamily) == 192);

/// kLeaf vectors in two cache lines. A component is the integer 256 high + low in units of
/// 2^(unit - exponent): 40 bits, so at most 2^-39 of the vector's largest component is lost. Only
/// leaves near the great circle are read, hence what this loses is little even of that.
/// Missing vectors are zeros.
struct alignas(128) NormalLeaf {
  std::int32_t high[3][kLeaf];
  std::uint8_t low[3][kLeaf];
  std::uint8_t exponent[kLeaf];
};
static_assert(sizeof(NormalLeaf) == 128);

inline constexpr int kMaxLevels = 12;  // enough for 2^36 vectors

/// Nodes of one level that a query opens at most.
inline constexpr std::size_t kMostOpened = 16384;

/// Node j of family f on level l is the parent of family 8 f + j on level l - 1, or of leaf 8 f + j
/// if l = 0. The highest level is a single family.
struct DirectionTreeNodes {
  const NormalLeaf* leaves = nullptr;
  std::uint64_t unit = 0;  ///< of the leaves: the biased exponent of a double
  const NormalFamily* levels[kMaxLevels] = {};
  /// Nodes of each level that a query may open before it gives up; at most kMostOpened.
  std::size_t limits[kMaxLevels] = {};
  int depth = 0;  ///< number of levels
};

struct NormalQuery {
  Slope<double> slope;
  double reach;       ///< |u| / |scale|: the circle meets a cap of radius r if |s| < |V| sin(r) reach
  double resolution;  ///< squared sine of the radius up to which a node is not opened
};

/// Adds the sums over the nodes of one query: of min(s, 0) to sums[0], or of V where s < 0 to
/// sums[0..2]. False if the query gave up.
using NormalKernel = bool (*)(const DirectionTreeNodes& nodes, const NormalQuery& query, TwoSum* sums);

struct DirectionTreeKernels {
  NormalKernel values, cuts;
  /// Squared sine of the largest angle between the unit vector `axis` and the vectors of leaves
  /// `begin` to `end`; infinite if an angle is not acute, or a vector too short to tell.
  double (*cap)(const DirectionTreeNodes& nodes, std::size_t begin, std::size_t end, const double* axis);
};

const DirectionTreeKernels& normal_kernels();

}  // namespace rectilin
