// The three views of a posed mesh, as pictures.
#pragma once

#include <array>
#include <string>

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// Square PNG pictures of `size` pixels of the mesh from the three axes of a frame: from +x, +y and +z of the posed
/// mesh, which is shown about its surface's centre of mass in one scale. Surfaces are shaded by their slope and drawn
/// darker the further away they are; the background is white. Throws MeshError if the mesh has no area.
std::array<std::string, 3> three_views(const Mesh& mesh, const Rotation& frame, int size = 132);

/// The same, silhouettes alone: black on white.
std::array<std::string, 3> three_silhouettes(const Mesh& mesh, const Rotation& frame, int size = 132);

}  // namespace rectilin::pose
