// Eq. (28), which is wrong as stated (papers/erratum.md), and what mends it.
#pragma once

#include "claims/tests.h"
#include "rectilin/optim/domain.h"

namespace rectilin::paper::claims {

/// Eq. (28) on a mesh in the pose it has: negative if R on the box [0, pi/2]^3 is certified to fall
/// short of R.
Finding check_paper_box(const TestMesh& tested);

/// The same for the mesh in a random pose: its R has not changed, but the box is another one.
Finding check_paper_box_in_another_pose(const TestMesh& tested, Random random);

/// Eq. (28) on cubes in random poses.
std::vector<Finding> check_cubes_on_paper_box(Random random);

/// The share of orientations that the paper's box reaches is 3/4.
std::vector<Finding> check_three_quarters(Random random);

/// The mend: `domain` reaches the best rotation and random ones, at the same P/S.
Finding check_domain_on_mesh(const TestMesh& tested, Random random, const Domain& domain);
/// The same for frames alone.
Finding check_chart(Random random, const Domain& domain);

}  // namespace rectilin::paper::claims
