// What section 7.1 says of views, their permutations and their number.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Table 1 has 24 different permutations, and they are those of the cube's rotations.
std::vector<Finding> check_table_1(Random random);
/// Eqs. (29)-(32): vertices of the subdivided octahedron, counted.
std::vector<Finding> check_sphere_sizes(Random random);
/// 24 permutations are enough on every level: each takes views to where the rotation takes their directions.
std::vector<Finding> check_permutations(Random random);
/// "44 % less storage": of 66 views against 100.
std::vector<Finding> check_storage(Random random);
/// "about 70 times quicker": in pairs of views.
std::vector<Finding> check_view_pairs(Random random);

}  // namespace rectilin::paper::claims
