// The interface between the orders of vectors (hilbert_order.cpp, kd_order.cpp) and their vector loops
// (order_kernels.cpp). Results are the same for every instruction set, bit for bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// How a direction becomes a cell.
struct CellMap {
  static constexpr int kBits = 16;  ///< bits of each of the cell's two coordinates

  /// Rows of a rotation. Vectors are turned to the side of the last row, and their directions to coordinates in a
  /// square whose middle is the last row.
  std::array<std::array<double, 3>, 3> rows;

  /// Four levels of a space-filling curve at once: bits 0 to 7 of an entry hold the place of a sub-cell among 256, and
  /// from bit 8 on the orientation of the curve in it; the entry is at 256 orientation + 16 x + y.
  std::array<std::int32_t, 4 * 256> curve;
};

inline constexpr std::uint64_t kDropped = ~std::uint64_t{0};

/// Vectors have sizes, the sums of the components' magnitudes. Products of the squares of two vectors neither overflow
/// nor, unless one of them is negligible, lose digits if no size is above kMost and the largest is at least kLeast.
struct SizeRange {
  static constexpr double kLeast = 0x1p-64, kMost = 0x1p64;
  bool none_above = true;    ///< no size is above kMost or not a number
  bool some_counts = false;  ///< a size is at least kLeast
};

/// For vectors `begin` to `end` (three doubles each): turns the vector to one side in place, and writes an item, with
/// the place of the vector's cell along the curve in its high half and the index of the vector in the low one, or
/// kDropped for a vector of length zero.
SizeRange find_cells(const CellMap& map, double* vectors, std::size_t begin, std::size_t end, std::uint64_t* items);

/// The stereographic projection of directions, up to sign, about the last row of a rotation: small squares stay
/// squares, and the hemisphere becomes a disc. Both coordinates are scaled alike, such that the longer range is from 0
/// to 65535. `across` and `up` are for intermediate results; all arrays have the size of the run.
void project(const VectorSpan<double>& run, const std::array<std::array<double, 3>, 3>& rows, float* across, float* up,
             std::uint16_t* whole_across, std::uint16_t* whole_up);

}  // namespace rectilin
