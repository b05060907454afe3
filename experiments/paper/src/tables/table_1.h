// Table 1 of the paper, as printed.
#pragma once

#include <array>

namespace rectilin::paper::tables {

using Permutation = std::array<int, 6>;

/// p_0 to p_23 of the octahedron's views, which are +x, -x, +y, -y, +z, -z.
inline constexpr std::array<Permutation, 24> kTable1{
    {{0, 1, 2, 3, 4, 5}, {0, 1, 4, 5, 3, 2}, {0, 1, 3, 2, 5, 4}, {0, 1, 5, 4, 2, 3}, {1, 0, 3, 2, 4, 5},
     {1, 0, 4, 5, 2, 3}, {1, 0, 2, 3, 5, 4}, {1, 0, 5, 4, 3, 2}, {4, 5, 2, 3, 1, 0}, {4, 5, 1, 0, 3, 2},
     {4, 5, 3, 2, 0, 1}, {4, 5, 0, 1, 2, 3}, {5, 4, 2, 3, 0, 1}, {5, 4, 0, 1, 3, 2}, {5, 4, 3, 2, 1, 0},
     {5, 4, 1, 0, 2, 3}, {2, 3, 1, 0, 4, 5}, {2, 3, 4, 5, 0, 1}, {2, 3, 0, 1, 5, 4}, {2, 3, 5, 4, 1, 0},
     {3, 2, 0, 1, 4, 5}, {3, 2, 4, 5, 1, 0}, {3, 2, 1, 0, 5, 4}, {3, 2, 5, 4, 0, 1}}};

}  // namespace rectilin::paper::tables
