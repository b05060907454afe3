// The convex hull of a mesh.
#pragma once

#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// The hull of the vertices that triangles use, as a closed triangle mesh: its vertices are the hull's corners (those
/// in the middle of a face or edge are left out but for rounding). By the library Qhull (Barber, Dobkin and Huhdanpaa
/// 1996). A flat mesh has a hull, too: its outline, once from above and once from below. Vertices within 1e-9 of the
/// mesh's size of one plane count as flat. Throws MeshError if they are all on a line. Thread safe.
Mesh convex_hull(const Mesh& mesh);

}  // namespace rectilin::pose
