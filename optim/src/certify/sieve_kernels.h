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

/// Which octants of the box cannot be settled, as bits: an octant's number has bit i set if it is the upper half of
/// axis i. Settled are octants outside the zone, and those on which the sum of three cuts is at least `enough`: for
/// each axis the one of its list that is greatest at the octant's middle. No list may be empty.
std::uint32_t open_octants(const Box& box, const std::array<CutList, 3>& lists, double enough);

}  // namespace rectilin::certification
