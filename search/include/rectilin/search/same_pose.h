// Two shapes side by side, turned alike.
#pragma once

#include <Eigen/Core>

#include "rectilin/mesh/mesh.h"

namespace rectilin::search {

struct SamePose {
  Eigen::Matrix3d rotation;  ///< of the second mesh's coordinates
  double distance;           ///< of the surfaces then, both of one size: root mean square, in radii
};

/// The rotation that lays the second mesh on the first, without a reflection. If they are nearly one shape, it is the
/// one of the best fit; else one of the 24 that take its frame of largest rectilinearity to the first's, whichever
/// leaves least between the surfaces. Throws MeshError if a mesh has no area.
SamePose same_pose(const Mesh& first, const Mesh& second);

}  // namespace rectilin::search
