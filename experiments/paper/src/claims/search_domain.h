// Eq. (28), which is wrong as stated, and its correction (papers/erratum.md).
#pragma once

#include "claims/tests.h"
#include "rectilin/optim/domain.h"

namespace rectilin::paper::claims {

/// Eq. (28) on a mesh in its own pose. The margin is negative if it is certified that R on the box [0, pi/2]^3 falls
/// short of R.
Finding check_paper_box(const TestMesh& tested);

/// The same for the mesh in a random pose, which has the same R but another box.
Finding check_paper_box_in_another_pose(const TestMesh& tested, Random random);

/// Eq. (28) on cubes in random poses.
std::vector<Finding> check_cubes_on_paper_box(Random random);

/// The share of orientations that the paper's box reaches is 3/4.
std::vector<Finding> check_three_quarters(Random random);

/// The correction: `domain` reaches the best rotation and random ones, with the same P/S.
Finding check_domain_on_mesh(const TestMesh& tested, Random random, const Domain& domain);
/// The same for random frames, without a mesh.
Finding check_domain_on_frames(Random random, const Domain& domain);

}  // namespace rectilin::paper::claims
