// Eqs. (8), (9) and (12): a triangle, and a mesh, against its projections.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Eq. (8) over all faces, at random rotations and where a face is parallel to a plane (equality).
Finding check_lower_per_face(const TestMesh& tested, Random random);

/// Eq. (9), also where a face looks at all three planes alike (equality).
Finding check_upper_per_face(const TestMesh& tested, Random random);

/// Eq. (12), at random rotations, at the best one and at the worst one found.
Finding check_bounds_of_mesh(const TestMesh& tested, Random random);

/// The greatest P/S among `count` random rotations.
struct Sampled {
  Rotation rotation;
  double ratio = 0;
};
Sampled greatest_ratio(const Objective& objective, Random random, int count);

}  // namespace rectilin::paper::claims
