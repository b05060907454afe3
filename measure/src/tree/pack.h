// Packs the numbers of a direction tree; the vector loops (direction_tree_kernels.cpp) read them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "tree/direction_tree_kernels.h"

namespace rectilin {

/// The biased exponent of the unit for leaves whose largest component is `largest`: their integers then take 40 bits
/// with the sign.
inline std::uint64_t leaf_unit(double largest) {
  constexpr std::uint64_t kBits = 38;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largest) >> 52;
  return std::max(exponent, kBits + 1) - kBits;
}

/// Writes `v` as vector j of a leaf; `unit` is that of the longest vector there may be.
inline void pack_vector(DirectionLeaf& leaf, std::size_t j, const Vector3& v, std::uint64_t unit) {
  const std::uint64_t below = unit - std::min(unit, leaf_unit(v.cwiseAbs().maxCoeff()));
  const std::uint64_t exponent = std::min<std::uint64_t>(below, 255);
  leaf.exponent[j] = static_cast<std::uint8_t>(exponent);
  const auto inverse = std::bit_cast<double>((2046 - (unit - exponent)) << 52);
  for (int c = 0; c < 3; ++c) {
    const double units = v[c] * inverse;
    const auto rounded = static_cast<std::int64_t>(units + std::copysign(0.5, units));
    const std::int64_t q = std::min(rounded, (std::int64_t{1} << 39) - 1);
    leaf.high[c][j] = static_cast<std::int32_t>(q >> 8);
    leaf.low[c][j] = static_cast<std::uint8_t>(q & 255);
  }
}

/// Writes child j of a family: the sum of its vectors, and |sum| sin(radius of their cap).
inline void pack_node(DirectionFamily& family, std::size_t j, const Vector3& sum, double radius) {
  const auto bits = std::bit_cast<std::uint64_t>(radius);
  constexpr int kDropped = 39;
  std::uint64_t kept = (bits + (std::uint64_t{1} << kDropped) - 1) >> kDropped;
  for (int c = 2; c >= 0; --c, kept >>= 8)
    family.sums[c][j] = (std::bit_cast<std::uint64_t>(sum[c]) & ~std::uint64_t{255}) | (kept & 255);
}

}  // namespace rectilin
