// Meshes in few bytes, for the viewer.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "rectilin/mesh/mesh.h"

namespace rectilin::serve {

constexpr std::size_t kMostShown = 200'000;  ///< triangles; a mesh of more is simplified if it can be

/// A mesh within the unit ball as little-endian bytes: "RMSH", the numbers of vertices and of triangles in the file
/// and here (three of 32 bits), three indices of 32 bits for each triangle, three coordinates of 16 bits for each
/// vertex, signed, of 1/32767. Vertices that no triangle uses are left out. Throws MeshError if it is too large even
/// when simplified.
std::string compact_mesh(const Mesh& mesh);

/// The mesh in such bytes. Throws MeshError if they are others.
Mesh mesh_of_compact(std::string_view bytes);

}  // namespace rectilin::serve
