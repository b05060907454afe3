#include "rectilin/mesh/mesh_io.h"

#include <cctype>
#include <new>
#include <optional>

#include "io/signature.h"
#include "io/soup.h"
#include "rectilin/base/whole_file.h"

namespace rectilin {
namespace {

std::string read_bytes(const std::filesystem::path& file) try {
  return read_whole_file(file);
} catch (const std::runtime_error& e) {
  throw MeshError(e.what());
}

std::optional<MeshFormat> format_of_content(std::string_view bytes) {
  if (looks_like_ply(bytes)) return MeshFormat::kPly;
  if (looks_like_off(bytes)) return MeshFormat::kOff;
  if (looks_like_stl(bytes)) return MeshFormat::kStl;
  return std::nullopt;
}

bool is_utf16(std::string_view bytes) { return bytes.substr(0, 2) == "\xFF\xFE" || bytes.substr(0, 2) == "\xFE\xFF"; }

PolygonSoup read_soup(std::string_view bytes, MeshFormat format, const std::string& name) {
  switch (format) {
    case MeshFormat::kOff:
      return read_off(bytes, name);
    case MeshFormat::kObj:
      return read_obj(bytes, name);
    case MeshFormat::kPly:
      return read_ply(bytes, name);
    case MeshFormat::kStl:
      return read_stl(bytes, name);
  }
  throw MeshError(name + ": unknown format");
}

}  // namespace

std::optional<MeshFormat> format_of_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".off") return MeshFormat::kOff;
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".stl") return MeshFormat::kStl;
  return std::nullopt;
}

LoadedMesh read_mesh(std::string_view bytes, MeshFormat format, const std::string& name) {
  if (bytes.empty()) throw MeshError(name + ": the file is empty");
  if (is_utf16(bytes)) throw MeshError(name + ":byte 0: UTF-16 text is not supported");
  if (const std::string_view kind = foreign_kind(bytes); !kind.empty() && !is_binary_stl(bytes))
    throw MeshError(name + ": not a mesh but " + std::string(kind));
  return assemble(read_soup(bytes, format, name), name);
}

LoadedMesh read_mesh(const std::filesystem::path& file) try {
  const std::string bytes = read_bytes(file);
  std::optional<MeshFormat> format = format_of_content(bytes);
  if (!format) format = format_of_extension(file);
  if (!format && !file.has_extension() && looks_like_obj(bytes)) format = MeshFormat::kObj;
  if (!format && bytes.empty()) throw MeshError(file.string() + ": the file is empty");
  if (!format && foreign_kind(bytes).empty())
    throw MeshError(file.string() + ": neither content nor name tell a known format");
  if (!format) throw MeshError(file.string() + ": not a mesh but " + std::string(foreign_kind(bytes)));
  return read_mesh(bytes, *format, file.string());
} catch (const std::bad_alloc&) {
  throw MeshError(file.string() + ": not enough memory");
}

}  // namespace rectilin
