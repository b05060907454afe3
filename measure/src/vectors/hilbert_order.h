// Puts area vectors in an order in which neighbours have neighbouring directions.
#pragma once

#include <cstdint>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Turns each vector to the side of a fixed hemisphere (v and -v are one to the measure), and returns the
/// indices of the nonzero ones along a Hilbert curve over that hemisphere. Vectors that share one of its
/// 2^32 cells are in order of exact direction, so that parallel ones are neighbours. O(N log N) at worst,
/// O(N) where directions spread. The same for any number of threads.
std::vector<std::uint32_t> order_by_direction(std::vector<Vector3>& vectors);

}  // namespace rectilin
