// Lists of meshes in files: text or CSV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/source.h"

namespace rectilin {

/// Does the file's extension make it a list: .txt, .lst or .csv?
bool is_manifest_name(std::string_view file);

/// The entries of a list as written, before folders and archives among them are expanded: names, sources made relative
/// to the list's folder, classes. Throws MeshError, "FILE:line N: reason".
std::vector<NamedSource> read_manifest(const std::string& file);

}  // namespace rectilin
