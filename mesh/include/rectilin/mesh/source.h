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

/// Replaces each folder by the mesh files in it and below (.off, .obj, .ply, .stl, in any case), sorted by path; other
/// sources stay as they are, existing or not. Links to folders are followed, and each folder is looked into once. What
/// is no mesh but looks like one by its name, the files `._NAME` of macOS, is passed over.
///
/// What cannot be looked at stays in the list in its own place, so that load_mesh() says why: folders that cannot be
/// read or hold no mesh, links to nowhere with the name of a mesh, and links to a folder that they are in.
std::vector<std::string> expand_folders(const std::vector<std::string>& sources);

/// The names in a list: one a line (LF or CRLF, with or without a UTF-8 byte order mark; empty lines do not count), or
/// each ended by NUL as `find -print0` writes them. Throws MeshError for text with NUL that is not such a list, UTF-16
/// for one. `name` stands for the list in errors.
std::vector<std::string> sources_in_list(std::string_view list, const std::string& name);

}  // namespace rectilin
