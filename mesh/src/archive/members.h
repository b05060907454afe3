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

/// Splits a source that names a member of an archive, `ARCHIVE::MEMBER`; nothing if it is another kind of source. The
/// first part must have an archive's extension.
std::optional<MemberName> parse_member(std::string_view source);

/// Sources of all meshes in an archive, in the order in which they are stored, which is the fastest order to read them
/// in. Throws MeshError.
std::vector<std::string> mesh_members(const std::string& archive);

/// The content of a member. The archive stays open for the next call, so that reading its members in order unpacks it
/// only once. Throws MeshError. Thread safe.
std::string read_member(const MemberName& name);

}  // namespace rectilin
