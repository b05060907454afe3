// How far a surface reaches in every direction from the origin.
#pragma once

#include <span>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::retrieval {

/// Spherical grid of n x n directions: polar angle theta_j = pi (j + 1/2) / n, azimuth phi_k = 2 pi k / n.
/// The largest distance from the origin at which the ray in each direction meets a triangle, 0 if none; index j * n +
/// k. `pole` (0, 1, 2) is the axis theta is measured from; phi goes from the next axis to the one after.
std::vector<double> radial_extent(const Mesh& mesh, int n, int pole);

/// The same in each of the given directions (unit vectors, in any order). Every triangle is tried against every
/// direction, so it is meant for some thousand directions at most.
std::vector<double> radial_extent(const Mesh& mesh, std::span<const Vector3> directions);

}  // namespace rectilin::retrieval
