// The cuts among which the sieve chooses; compiled once for each instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "certify/cell.h"
#include "certify/cut_table.h"

namespace rectilin::certification {

/// The cuts that may be the greatest for one axis somewhere on a box, as rows of a table. By how much a row exceeds the
/// first one is known to first order and in single precision: every row makes a valid bound, so that a row may be
/// chosen that is not quite the greatest. At the point p = middle + (t_1 e_1, t_2 e_2, t_3 e_3) of a box with the half
/// edges e it is lead + t_1 along[0] + t_2 along[1] + t_3 along[2].
struct CutList {
  static constexpr std::size_t kMost = 128;
  template <class T>
  using PerRow = std::array<T, kMost + CutTable::kLanes>;

  std::size_t size = 0;
  PerRow<std::uint32_t> row;
  PerRow<float> lead;
  std::array<PerRow<float>, 3> along;
};

using CutLists = std::array<CutList, 3>;

/// A list for each axis, of the cell's own cuts, the best at the middle first, and of those that were taken near where
/// the corners and the middle of its box point to and that exceed this one somewhere on the box. After the last row
/// there is one more that exceeds nothing. `middle` is the rotation at the middle.
void find_rivals(const Cell& cell, const CutTable& table, const Rotation& middle, CutLists& lists);

}  // namespace rectilin::certification
