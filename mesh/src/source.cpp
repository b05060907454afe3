#include "rectilin/mesh/source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "archive/members.h"
#include "archive/unpack.h"
#include "io/soup.h"
#include "io/text.h"
#include "manifest.h"
#include "rectilin/mesh/shapes.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kShapePrefix = "shape:";

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied)) {
    std::error_code ignored;  // a link to nowhere is as good as no file
    if (!entry.is_regular_file(ignored)) continue;
    if (format_of_extension(entry.path()) || is_archive_name(entry.path().native()))
      files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

bool is_folder(const std::string& source) {
  std::error_code ignored;
  return !is_shape_source(source) && fs::is_directory(source, ignored);
}

bool is_file(const std::string& source) {
  std::error_code ignored;
  return !is_shape_source(source) && fs::is_regular_file(source, ignored);
}

/// Why a folder stands in the list in the place of its files.
[[noreturn]] void complain_of_folder(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator(folder, error);
  throw MeshError(folder + ": " + (error ? error.message() : "no mesh file in this folder"));
}

/// A compressed file is its only member; why an archive stands in the list in the place of its members is said.
LoadedMesh load_archive(const std::string& file) {
  const std::vector<std::string> members = mesh_members(file);
  if (members.empty()) throw MeshError(file + ": no mesh file in this archive");
  if (members.size() > 1) throw MeshError(file + ": an archive of " + std::to_string(members.size()) + " meshes");
  return load_mesh(members.front());
}

LoadedMesh load_member(const std::string& source, const MemberName& name) {
  const auto beside = [&](const std::string& path) {
    const fs::path member = (fs::path(name.member).parent_path() / path).lexically_normal();
    try {
      return read_member({name.archive, member.string()});
    } catch (const MeshError&) {
      throw MeshError(source + ": " + rectilin::quoted(path) + " is not in the archive");
    }
  };
  try {
    return read_mesh(read_member(name), source, beside);
  } catch (const std::bad_alloc&) {
    throw MeshError(source + ": not enough memory");
  }
}

bool is_mesh_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string begin(1024, '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  return looks_like_off(begin) || looks_like_ply(begin) || looks_like_stl(begin);
}

/// What stands for an entry: the text behind the entry's source is put behind its name, too.
void expand(const NamedSource& entry, bool in_manifest, std::vector<NamedSource>& all) {
  const std::size_t before = all.size();
  const auto expand_inner = [&](const std::string& source) {
    NamedSource inner{entry.name + source.substr(std::min(source.size(), entry.source.size())), source, entry.group};
    if (is_archive_name(source) && !parse_member(source)) expand(inner, true, all);
    else all.push_back(std::move(inner));
  };
  try {
    if (is_folder(entry.source)) {
      for (const std::string& file : files_below(entry.source)) expand_inner(file);
    } else if (is_archive_name(entry.source) && !parse_member(entry.source) && is_file(entry.source)) {
      for (const std::string& member : mesh_members(entry.source)) expand_inner(member);
    } else if (!in_manifest && is_manifest_name(entry.source) && is_file(entry.source) && !is_mesh_text(entry.source)) {
      for (const NamedSource& listed : read_manifest(entry.source)) expand(listed, true, all);
      return;  // its errors are the user's own, and an empty list is one
    }
  } catch (const fs::filesystem_error&) {  // left to load_mesh()
  } catch (const MeshError&) {
    if (!in_manifest && is_manifest_name(entry.source)) throw;
    all.resize(before);
  }
  if (all.size() == before) all.push_back(entry);
}

}  // namespace

bool is_shape_source(std::string_view source) { return source.starts_with(kShapePrefix); }

LoadedMesh load_mesh(const std::string& source) {
  if (is_folder(source)) complain_of_folder(source);
  if (is_shape_source(source)) {
    LoadedMesh loaded{make_shape(Spec::parse(std::string_view(source).substr(kShapePrefix.size()))), {}};
    loaded.report.vertices = loaded.mesh.vertices.size();
    loaded.report.polygons = loaded.mesh.triangles.size();
    return loaded;
  }
  if (const auto member = parse_member(source); member && !is_file(source)) return load_member(source, *member);
  return is_archive_name(source) ? load_archive(source) : read_mesh(source);
}

std::vector<NamedSource> expand_sources(const std::vector<std::string>& sources) {
  std::vector<NamedSource> all;
  for (const std::string& source : sources) expand({source, source, {}}, false, all);
  return all;
}

std::vector<std::string> expand_folders(const std::vector<std::string>& sources) {
  std::vector<std::string> all;
  for (NamedSource& entry : expand_sources(sources)) all.push_back(std::move(entry.source));
  return all;
}

}  // namespace rectilin
