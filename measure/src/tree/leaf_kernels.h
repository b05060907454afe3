// The interface between the building of a direction tree (direction_tree_build.cpp) and its vector loop
// (leaf_kernels.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "rectilin/base/rotation.h"
#include "sums/flat_sum_kernels.h"
#include "tree/direction_tree_kernels.h"

namespace rectilin {

/// The biased exponent of the unit for leaves whose largest component is `largest`: their integers then take
/// kLeafBits + 2 bits with the sign.
inline constexpr std::uint64_t kLeafBits = 38;
std::uint64_t leaf_unit(double largest);

/// Fills the leaves for a run of vectors, the last of them up to kLeaf with zeros, and writes the sum of each leaf;
/// `unit` is that of the longest vector there may be.
///
/// The sign of an area vector has no meaning, but vectors that are neighbours up to sign must point the same way for
/// their sum to stand for them. So each is turned to the side of the one before it, and the first to that of an
/// arbitrary axis.
void fill_leaves(const VectorSpan<double>& run, std::uint64_t unit, DirectionLeaf* leaves, Vector3* sums);

}  // namespace rectilin
