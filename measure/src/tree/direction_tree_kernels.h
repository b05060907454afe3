// The layout of a direction tree in memory, and the interface between its driver (direction_tree.cpp) and its
// vector loops.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sums/slope.h"
#include "sums/two_sum.h"

namespace rectilin {

/// Siblings are tested together: eight doubles fill one AVX-512 register, or a few narrower ones.
inline constexpr std::size_t kFan = 8;

/// Number of vectors in a leaf. Smaller leaves mean fewer vectors that are summed one by one, but more nodes.
inline constexpr std::size_t kLeaf = 8;

/// Number of nodes whose terms are summed in registers before they go to the compensated sums. It bounds the number of
/// terms in a lane, and so the rounding error.
inline constexpr std::size_t kChunkNodes = 256;

/// A family: kFan siblings in three cache lines, with their sums V, component by component, and caps around them. The
/// cost of a query of a large tree is the number of cache lines that it reads, so the caps take no room of their own:
/// the last byte of each component of V holds a byte of the cap's |V| sin(radius), a double without its sign and its
/// lower 39 bits, rounded up. This costs a sum 2^-44 of its size. The radius is infinite if the cap reaches a right
/// angle. Missing siblings are all zeros.
struct alignas(64) DirectionFamily {
  std::uint64_t sums[3][kFan];
};
static_assert(sizeof(DirectionFamily) == 192);

/// A leaf: kLeaf vectors in two cache lines. A component is the integer 256 high + low in units of 2^(unit - exponent):
/// 40 bits, so it loses at most 2^-39 of the vector's largest component. Only leaves near the great circle are read, so
/// the effect on a sum is small even compared with that. Missing vectors are zeros.
struct alignas(128) DirectionLeaf {
  std::int32_t high[3][kLeaf];
  std::uint8_t low[3][kLeaf];
  std::uint8_t exponent[kLeaf];
};
static_assert(sizeof(DirectionLeaf) == 128);

inline constexpr int kMaxLevels = 12;  // enough for 2^36 vectors

/// Largest number of nodes of one level that a query opens.
inline constexpr std::size_t kMostOpened = 16384;

struct Twig;

/// Node j of family f on level l is the parent of family 8 f + j on level l - 1, or of leaf 8 f + j if l = 0. The
/// highest level is a single family.
struct DirectionTreeNodes {
  const DirectionLeaf* leaves = nullptr;
  std::uint64_t unit = 0;  ///< unit of the leaves: the biased exponent of a double
  const DirectionFamily* levels[kMaxLevels] = {};
  /// For each level how many nodes a query may open before it gives up; at most kMostOpened.
  std::size_t limits[kMaxLevels] = {};
  int depth = 0;      ///< number of levels
  double widths = 0;  ///< the largest sum of the radii of leaves that a query may read from twigs
};

struct DirectionQuery {
  Slope<double> slope;
  double reach;                 ///< |u| / |scale|: the circle meets a cap of radius r if |s| < |V| sin(r) reach
  double resolution;            ///< squared sine of the radius up to which a node is not opened
  const Twig* twigs = nullptr;  ///< of the nodes of level 1, if there are any
};

/// Adds the sums over the nodes of one query: of min(s, 0) to sums[0], or of V where s < 0 to sums[0..2]. Returns false
/// if the query gave up.
using DirectionKernel = bool (*)(const DirectionTreeNodes& nodes, const DirectionQuery& query, TwoSum* sums);

struct DirectionTreeKernels {
  DirectionKernel values, cuts;
  /// The squared sine of the largest angle between the unit vector `axis` and the vectors of the leaves `begin` to
  /// `end`; infinite if an angle is not acute, or if a vector is too short to tell.
  double (*cap)(const DirectionTreeNodes& nodes, std::size_t begin, std::size_t end, const double* axis);
};

const DirectionTreeKernels& normal_kernels();

}  // namespace rectilin
