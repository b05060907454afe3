// Two surfaces in one picture.
#pragma once

#include <string>

#include "rectilin/mesh/mesh.h"

namespace rectilin::search {

/// Takes points from one file's coordinates to another's: x becomes linear * x + shift. Turns, scales and moves, and
/// reflects if the determinant is negative.
struct Placement {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vector3 shift = Vector3::Zero();
};

/// The first mesh and over it the second, placed, as a square PNG file of `size` pixels a row (1 to 5461), from in
/// front, the right and above in the frame of the first's largest rectilinearity. What coincides is grey, as in
/// thumbnails; what only the first has is blue, what only the second has is orange.
std::string overlay_picture(const Mesh& first, const Mesh& second, const Placement& placement, int size = 280);

}  // namespace rectilin::search
