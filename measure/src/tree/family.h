// How a family of a direction tree holds its nodes, one by one; nodes-inl.h reads them in vector registers.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "rectilin/base/rotation.h"
#include "tree/direction_tree_kernels.h"

namespace rectilin {

/// A node: the sum V of its vectors, and |V| sin(radius) of their cap.
struct Node {
  Vector3 sum;
  double radius;
};

/// Lower bits of the radius that are not kept, and the sign is not either.
inline constexpr int kDroppedBits = 39;

/// Writes child j of a family; the radius is rounded up, and the sum loses its last bits to it.
inline void store_node(DirectionFamily& family, std::size_t j, const Node& node) {
  const auto bits = std::bit_cast<std::uint64_t>(node.radius);
  std::uint64_t kept = (bits + (std::uint64_t{1} << kDroppedBits) - 1) >> kDroppedBits;
  for (int c = 2; c >= 0; --c, kept >>= 8)
    family.sums[c][j] = (std::bit_cast<std::uint64_t>(node.sum[c]) & ~std::uint64_t{255}) | (kept & 255);
}

/// Child j of a family. The sum is as the loops over nodes take it, with the radius's bits at its end.
inline Node load_node(const DirectionFamily& family, std::size_t j) {
  Node result;
  std::uint64_t kept = 0;
  for (int c = 0; c < 3; ++c) {
    result.sum[c] = std::bit_cast<double>(family.sums[c][j]);
    kept = kept << 8 | (family.sums[c][j] & 255);
  }
  result.radius = std::bit_cast<double>(kept << kDroppedBits);
  return result;
}

}  // namespace rectilin
