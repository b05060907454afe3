// Tests eight small boxes at once, each with the best cuts at its middle; compiled once for each instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "certify/box.h"
#include "certify/cut_table.h"

namespace rectilin::certification {

/// Cuts that may be the best for one axis somewhere on a box, as a structure of arrays.
struct CutList {
  static constexpr std::size_t kMost = 256;

  std::size_t size = 0;
  std::array<double, kMost + CutTable::kLanes> x, y, z;

  void add(const Eigen::Vector3d& slope) {
    x[size] = slope[0], y[size] = slope[1], z[size] = slope[2];
    ++size;
  }
};

/// Adds those cuts of a block that may exceed the cut `known` at a vector that is at most `reach` from `middle`, as
/// long as there is room.
void add_rivals(const CutTable::Block& block, const Eigen::Vector3d& known, const Eigen::Vector3d& middle, double reach,
                CutList& rivals);

/// What three cuts say of the octants of a box: for each axis the one that is greatest at the octant's middle. An
/// octant's number has bit i set if it is the upper half of axis i.
struct Octants {
  std::uint32_t open = 0;       ///< as bits, those that are in the zone and whose bound is less than what is enough
  std::array<double, 8> bound;  ///< of open ones: the objective is nowhere less on the octant, up to rounding
  std::array<double, 8> value;  ///< the sum of the three cuts at the middle
};

/// Tests the octants of a box. No list may be empty.
Octants test_octants(const Box& box, const std::array<CutList, 3>& lists, double enough);

}  // namespace rectilin::certification
