// unroundness() for those who have the surface and its hull at hand.
#pragma once

#include "rectilin/pose/roundness.h"
#include "surface.h"

namespace rectilin::pose {

double unroundness(const Surface& surface, const Mesh& hull, const Vector3& axis);

/// Sets the pose's uniqueness to continuum or none if the mesh is a body of revolution about an axis of its frame, up
/// to `tolerance`; else leaves it.
void note_roundness(struct Pose& pose, const Surface& surface, const Mesh& hull, double tolerance = 0.02);

}  // namespace rectilin::pose
