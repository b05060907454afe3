// What section 7.1 says about views, their permutations and their number.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Table 1 has 24 different permutations, which are those that the rotations of the cube produce.
std::vector<Finding> check_table_1(Random random);
/// Eqs. (29)-(32): counts the vertices of the subdivided octahedron.
std::vector<Finding> check_sphere_sizes(Random random);
/// 24 permutations are enough on every level: each maps views in the way that its rotation maps their directions.
std::vector<Finding> check_permutations(Random random);
/// "44 % less storage": 66 views compared with 100.
std::vector<Finding> check_storage(Random random);
/// "about 70 times quicker": counts pairs of views.
std::vector<Finding> check_view_pairs(Random random);

}  // namespace rectilin::paper::claims
