// Is a mesh a body of revolution, nearly?
#pragma once

#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// How far the mesh is from a body of revolution about a direction (unit vector): 0 for a perfect one. The largest of
/// three relative differences: of the two second moments of the surface across the axis, (a - b)/a with a >= b; and of
/// the width and of the silhouette's area of the convex hull, seen across the axis from 24 directions in equal steps,
/// (max - min)/(max + min), which is how far they stray to either side of the middle. Throws MeshError if the mesh has
/// no area.
double unroundness(const Mesh& mesh, const Vector3& axis);

}  // namespace rectilin::pose
