// A frame to work in that turns with the mesh.
#pragma once

#include "rectilin/pose/pose.h"
#include "surface.h"

namespace rectilin::pose {

/// Grids and scans look at a mesh from directions of their own, and what they find depends a little on how the mesh
/// lies to them. So it is first turned into a frame that depends on the mesh alone: its principal axes with directions
/// or, where these are nearly equal, its rectilinear pose. Copies of a mesh in other positions then go through the same
/// computation but for rounding.
Rotation working_frame(const Surface& surface);

/// The surface turned by `rotation`.
Surface turned(const Surface& surface, const Rotation& rotation);

/// The pose of the surface that was turned by `rotation` before the pose was found.
Pose turned_back(Pose pose, const Rotation& rotation);

}  // namespace rectilin::pose
