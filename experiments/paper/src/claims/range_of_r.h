// Theorems 2 and 3: the range of S/P and R, its end at the sphere, and invariance.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Theorem 2.1: R found, and so S/P - 2/3, is positive.
Finding check_positive(const TestMesh& tested);

/// Theorem 3.1: R found is in (0, 1].
Finding check_range(const TestMesh& tested);

/// Theorem 3.4: certified enclosures of R before and after a random similarity (a reflection every
/// other time) overlap.
Finding check_similarity(const TestMesh& tested, Random random);

/// Theorems 2.2 and 3.3: R of spheres falls like the number of faces to the power -1.
std::vector<Finding> check_octahedral_spheres(Random random);  ///< Fig. 5, the regular sequence
std::vector<Finding> check_even_spheres(Random random);        ///< an irregular one

/// Eq. (24): the mean of P/S over all rotations is 3/2. P is a sum of three values of h, one on
/// each axis, and each axis is uniform on the sphere, so this is three times the mean of h over the
/// sphere.
Finding check_mean(const TestMesh& tested);

/// What check_mean() averages over: points spread evenly over the upper half of the sphere, enough
/// for h is even.
std::vector<Vector3> spread_directions(int count);
inline constexpr int kDirections = 3000;

}  // namespace rectilin::paper::claims
