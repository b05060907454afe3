// Meshes from and to files: OFF, OBJ, PLY and STL.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

struct LoadedMesh {
  Mesh mesh;
  MeshReport report;
};

enum class MeshFormat { kOff, kObj, kPly, kStl };

/// By .off, .obj, .ply or .stl, in small letters or capitals.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& file);

/// Reads a mesh file; the format is taken from the content where that decides it, else from the
/// extension. Throws MeshError for anything malformed: a bad index, a truncated file, counts the
/// file cannot hold, no triangle, zero total area. Thread safe.
///
/// What is read: OFF text with any of the prefixes ST, C, N, 4 and n, one vertex or face to a line;
/// OBJ `v` and `f` (other statements are ignored); PLY text and binary of both byte orders, faces
/// and triangle strips; STL text and binary. Text may have any line ending and a UTF-8 byte order
/// mark.
///
/// A polygon becomes a fan if the fan does not fold over itself, else its ears are clipped, so that
/// a planar concave polygon keeps its area. Both look at the polygon along the coordinate axis
/// nearest to its normal. A polygon of many thousand corners may be so intricate, or cross itself so
/// often, that cutting it would take too long; it is refused.
///
/// Time is within a log factor of the file's size, and memory within a small multiple of it,
/// whatever a header claims.
LoadedMesh read_mesh(const std::filesystem::path& file);

/// The same from bytes in memory; `name` stands for the file in errors.
LoadedMesh read_mesh(std::string_view bytes, MeshFormat format, const std::string& name);

struct WriteOptions {
  bool binary = true;  ///< PLY and STL only; OFF and OBJ are text
};

/// Writes a mesh in the format of the file's extension (.off, .obj, .ply, .stl). Text and binary
/// PLY carry doubles that read back bit for bit; binary STL holds single precision, as the format
/// demands. Throws MeshError when the extension is unknown or a coordinate or count is beyond what the format
/// holds, std::runtime_error when the file cannot be written (see write_whole_file()). Thread safe.
void write_mesh(const std::filesystem::path& file, const Mesh& mesh, const WriteOptions& options = {});

}  // namespace rectilin
