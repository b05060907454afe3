#include "rectilin/mesh/source.h"

#include <algorithm>
#include <filesystem>

#include "rectilin/mesh/shapes.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kShapePrefix = "shape:";

bool is_shape(std::string_view source) { return source.starts_with(kShapePrefix); }

std::vector<std::string> mesh_files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied)) {
    std::error_code ignored;  // a link to nowhere is as good as no file
    if (entry.is_regular_file(ignored) && format_of_extension(entry.path())) files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  return files;
}

bool is_folder(const std::string& source) {
  std::error_code ignored;
  return !is_shape(source) && fs::is_directory(source, ignored);
}

/// Why a folder stands in the list in the place of its files.
[[noreturn]] void complain_of_folder(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator(folder, error);
  throw MeshError(folder + ": " + (error ? error.message() : "no mesh file in this folder"));
}

}  // namespace

LoadedMesh load_mesh(const std::string& source) {
  if (is_folder(source)) complain_of_folder(source);
  if (!is_shape(source)) return read_mesh(source);
  LoadedMesh loaded{make_shape(Spec::parse(std::string_view(source).substr(kShapePrefix.size()))), {}};
  loaded.report.vertices = loaded.mesh.vertices.size();
  loaded.report.polygons = loaded.mesh.triangles.size();
  return loaded;
}

std::vector<std::string> expand_folders(const std::vector<std::string>& sources) {
  std::vector<std::string> all;
  for (const std::string& source : sources) {
    std::vector<std::string> files;
    try {
      if (is_folder(source)) files = mesh_files_below(source);
    } catch (const fs::filesystem_error&) {  // left to load_mesh()
    }
    if (files.empty()) files = {source};
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

}  // namespace rectilin
