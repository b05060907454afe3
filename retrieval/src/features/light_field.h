// The cameras of the light field descriptor, and how its light fields can be laid over each other.
#pragma once

#include <array>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::retrieval {

inline constexpr std::size_t kFields = 10, kCameras = 10;

/// Directions of the cameras: light field f looks from the vertices of a dodecahedron, turned so that the ten are
/// spread evenly (Chen, Tian, Shen, Ouhyoung 2003); index f * kCameras + c. Ten of its twenty vertices are enough, as a
/// silhouette from behind is the mirror image. The turns are those of the authors' program, version 1.8.
const std::array<Vector3, kFields * kCameras>& light_field_directions();

/// The 60 rotations of the dodecahedron as permutations of its ten axes: they take the axis of camera c to that of
/// camera [i][c].
const std::vector<std::array<std::uint8_t, kCameras>>& light_field_rotations();

}  // namespace rectilin::retrieval
