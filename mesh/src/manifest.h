// Lists of meshes in files: text or CSV.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/source.h"

namespace rectilin {

/// Whether the file's name is that of a list: .txt, .lst or .csv.
bool is_manifest_name(std::string_view file);

/// The entries of a list as written, none replaced by what is in it: names, sources relative to where the list is,
/// classes. Throws MeshError, "FILE:line N: reason".
std::vector<NamedSource> read_manifest(const std::string& file);

}  // namespace rectilin
