// Small pictures of meshes.
#pragma once

#include <string>

#include "rectilin/mesh/mesh.h"

namespace rectilin::render {

enum class Up { kY, kZ };

/// The mesh from in front, the right and above, in parallel projection, as large as fits: a square
/// PNG file. Faces are shaded by their slope, creases and outlines drawn. Takes any soup of any
/// size; orientation does not matter.
std::string thumbnail(const Mesh& mesh, Up up);

}  // namespace rectilin::render
