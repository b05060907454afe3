#include "rectilin/mesh/mesh_io.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <optional>

#include "io/signature.h"
#include "io/soup.h"
#include "io/text.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/whole_file.h"

namespace rectilin {
namespace {

std::string read_bytes(const std::filesystem::path& file) try {
  return read_whole_file(file);
} catch (const std::runtime_error& e) {
  throw MeshError(e.what());
}

std::optional<MeshFormat> format_of_content(std::string_view bytes) {
  if (looks_like_glb(bytes)) return MeshFormat::kGltf;
  if (looks_like_ply(bytes)) return MeshFormat::kPly;
  if (looks_like_off(bytes)) return MeshFormat::kOff;
  if (looks_like_stl(bytes)) return MeshFormat::kStl;
  if (looks_like_3mf(bytes)) return MeshFormat::k3mf;
  return std::nullopt;
}

bool is_utf16(std::string_view bytes) { return bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF"; }

PolygonSoup read_soup(std::string_view bytes, MeshFormat format, const std::string& name, const ReadBeside& beside) {
  switch (format) {
    case MeshFormat::kOff:
      return read_off(bytes, name);
    case MeshFormat::kObj:
      return read_obj(bytes, name);
    case MeshFormat::kPly:
      return read_ply(bytes, name);
    case MeshFormat::kStl:
      return read_stl(bytes, name);
    case MeshFormat::kGltf:
      return read_gltf(bytes, beside, name);
    case MeshFormat::k3mf:
      return read_3mf(bytes, name);
  }
  throw MeshError(name + ": unknown format");
}

/// A file named by a mesh file: below its folder, whatever links and dots are in the way, or not at all.
std::string read_beside(const std::filesystem::path& mesh, const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path folder = mesh.has_parent_path() ? mesh.parent_path() : fs::path(".");
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  const fs::path file = fs::canonical(folder / path, error);
  if (error) throw MeshError(mesh.string() + ": " + rectilin::quoted(path) + ": " + system_reason(error));
  if (fs::path(path).is_absolute() || std::ranges::mismatch(root, file).in1 != root.end())
    throw MeshError(mesh.string() + ": " + rectilin::quoted(path) + " is outside its folder");
  return read_bytes(file);
}

}  // namespace

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".off") return MeshFormat::kOff;
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".stl") return MeshFormat::kStl;
  if (extension == ".gltf" || extension == ".glb") return MeshFormat::kGltf;
  if (extension == ".3mf") return MeshFormat::k3mf;
  return std::nullopt;
}

LoadedMesh read_mesh(std::string_view bytes, MeshFormat format, const std::string& name, const ReadBeside& beside) {
  if (bytes.empty()) throw MeshError(name + ": the file is empty");
  if (is_utf16(bytes)) throw MeshError(name + ":byte 0: UTF-16 text is not supported");
  if (const std::string_view kind = foreign_kind(bytes);
      !kind.empty() && format != MeshFormat::k3mf && format != MeshFormat::kGltf && !is_binary_stl(bytes))
    throw MeshError(name + ": not a mesh but " + std::string(kind));
  return assemble(read_soup(bytes, format, name, beside), name);
}

LoadedMesh read_mesh(std::string_view bytes, const std::string& name, const ReadBeside& beside) {
  std::optional<MeshFormat> format = format_of_content(bytes);
  if (!format) format = format_of_extension(name);
  if (!format && bytes.empty()) throw MeshError(name + ": the file is empty");
  if (!format && foreign_kind(bytes).empty()) throw MeshError(name + ": neither content nor name tell a known format");
  if (!format) throw MeshError(name + ": not a mesh but " + std::string(foreign_kind(bytes)));
  return read_mesh(bytes, *format, name, beside);
}

LoadedMesh read_mesh(const std::filesystem::path& file) try {
  const std::string bytes = read_bytes(file);
  const auto beside = [&](const std::string& path) { return read_beside(file, path); };
  if (!file.has_extension() && !format_of_content(bytes) && looks_like_obj(bytes))
    return read_mesh(bytes, MeshFormat::kObj, file.string(), beside);
  return read_mesh(bytes, file.string(), beside);
} catch (const std::bad_alloc&) {
  throw MeshError(file.string() + ": not enough memory");
}

}  // namespace rectilin
