#include "rectilin/measure/source.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "rectilin/measure/shapes.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kShapePrefix = "shape:";

bool is_shape(std::string_view source) { return source.starts_with(kShapePrefix); }

bool is_mesh_file(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl";
}

std::vector<std::string> mesh_files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (entry.is_regular_file() && is_mesh_file(entry.path())) files.push_back(entry.path().string());
  if (files.empty()) throw MeshError(folder.string() + ": no mesh file in this folder");
  std::ranges::sort(files);
  return files;
}

}  // namespace

LoadedMesh load_mesh(const std::string& source) {
  if (!is_shape(source)) return read_mesh(source);
  LoadedMesh loaded{make_shape(Spec::parse(std::string_view(source).substr(kShapePrefix.size()))), {}};
  loaded.report.vertices = loaded.mesh.vertices.size();
  loaded.report.polygons = loaded.mesh.triangles.size();
  return loaded;
}

std::vector<std::string> expand_folders(const std::vector<std::string>& sources) {
  std::vector<std::string> all;
  for (const std::string& source : sources) {
    std::error_code ignored;
    if (is_shape(source) || !fs::is_directory(source, ignored)) {
      all.push_back(source);
      continue;
    }
    try {
      const auto files = mesh_files_below(source);
      all.insert(all.end(), files.begin(), files.end());
    } catch (const fs::filesystem_error& e) {
      throw MeshError(source + ": " + e.code().message());
    }
  }
  return all;
}

}  // namespace rectilin
