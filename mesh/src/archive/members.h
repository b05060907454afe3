// Members of archives as sources of meshes: `archive.zip::path/in/it.obj`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rectilin {

struct MemberName {
  std::string archive, member;
};

/// The parts of a source that names a member; the first part ends like an archive.
std::optional<MemberName> parse_member(std::string_view source);

/// The members that are meshes, by their names, in the order in which they are stored, which is that in which they are
/// read fast. Throws MeshError.
std::vector<std::string> mesh_members(const std::string& archive);

/// The content of a member. Archives stay open for the next member: going forward through one unpacks it once. Throws
/// MeshError. Thread safe.
std::string read_member(const MemberName& name);

}  // namespace rectilin
