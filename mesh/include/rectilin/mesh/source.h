// Where meshes come from: files, folders and built-in shapes, named by one string each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/mesh_io.h"

namespace rectilin {

/// Loads `shape:NAME?key=value` or the mesh file of that name. Throws MeshError, also for a folder, or ParameterError
/// for a shape that cannot be made.
LoadedMesh load_mesh(const std::string& source);

/// Replaces each folder by the mesh files in it and below (.off, .obj, .ply, .stl, in any case), sorted by
/// path; other sources stay as they are, existing or not, and so do folders without meshes or that cannot be read.
std::vector<std::string> expand_folders(const std::vector<std::string>& sources);

}  // namespace rectilin
