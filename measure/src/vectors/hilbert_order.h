// Sorts area vectors so that neighbours have similar directions.
#pragma once

#include <cstdint>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Turns each vector to the same side of a fixed plane (v and -v are the same to the measure), and returns the indices
/// of the nonzero ones along a Hilbert curve over that hemisphere. Vectors in the same one of its 2^32 cells are sorted
/// by their exact direction, unless all are parallel, so that parallel ones are neighbours. O(N log N) at worst, O(N) if
/// the directions are spread out. The result is the same for any number of threads.
std::vector<std::uint32_t> order_by_direction(std::vector<Vector3>& vectors);

}  // namespace rectilin
