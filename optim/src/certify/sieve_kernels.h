// Tests the octants of boxes, each with the best cuts at its middle; compiled once for each instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "certify/box.h"
#include "certify/rivals.h"

namespace rectilin::certification {

/// What three cuts say of the octants of a box: for each axis one that is greatest at the octant's middle, as far as
/// the lists tell. An octant's number has bit i set if it is the upper half of axis i.
struct Octants {
  std::uint32_t open = 0;       ///< as bits, those that are in the zone and whose bound is less than what is enough
  std::array<double, 8> bound;  ///< of open ones: the objective is nowhere less on the octant, up to rounding
  std::array<double, 8> value;  ///< the sum of the three cuts at the middle
};

inline constexpr std::size_t kMostBoxes = 8;

/// Tests the octants of at most kMostBoxes boxes inside of the one for which the lists were made.
void test_octants(std::span<const Box> boxes, const Box& whole, const CutLists& lists, const CutTable& table,
                  double enough, Octants* results);

}  // namespace rectilin::certification
