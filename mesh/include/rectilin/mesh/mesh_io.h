// Meshes from files, OFF, OBJ, PLY, STL, glTF and 3MF, and to files of the first four.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "rectilin/base/parameters.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

struct LoadedMesh {
  Mesh mesh;
  MeshReport report;
};

enum class MeshFormat { kOff, kObj, kPly, kStl, kGltf, k3mf };

/// By .off, .obj, .ply, .stl, .gltf, .glb or .3mf, in small letters or capitals.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& file);

/// Reads a mesh file; the format is taken from the content where that decides it, else from the
/// extension. Throws MeshError for anything malformed: a bad index, a truncated file, counts the
/// file cannot hold, no triangle, zero total area. Thread safe.
///
/// What is read: OFF text with any of the prefixes ST, C, N, 4 and n, one vertex or face to a line;
/// OBJ `v` and `f` (other statements are ignored); PLY text and binary of both byte orders, faces
/// and triangle strips; STL text and binary. Text may have any line ending and a UTF-8 byte order
/// mark; glTF 2.0, text and binary, with the buffers in files beside it and below (never elsewhere); 3MF.
///
/// Of glTF and 3MF the scene is read: what it shows, or is to be built, with every instance in its place, in metres
/// (see MeshReport::scene). Skins, morph targets, materials and images are left out; a file that needs a compression of
/// its geometry (Draco, meshopt) is refused, and so is one whose instances come to more than 2^25 vertices and
/// triangles. A 3MF file may unpack to 300 times its size, or to 64 MiB if that is more.
///
/// A polygon becomes a fan if the fan does not fold over itself, else its ears are clipped, so that
/// a planar concave polygon keeps its area. Both look at the polygon along the coordinate axis
/// nearest to its normal. A polygon of many thousand corners may be so intricate, or cross itself so
/// often, that cutting it would take too long; it is refused.
///
/// Time is within a log factor of the file's size, and memory within a small multiple of it,
/// whatever a header claims.
LoadedMesh read_mesh(const std::filesystem::path& file);

/// The bytes of a file beside a mesh file or below, by its relative path. Throws MeshError.
using ReadBeside = std::function<std::string(const std::string& path)>;

/// The same from bytes in memory; `name` stands for the file in errors. Without `beside` no other file is read.
LoadedMesh read_mesh(std::string_view bytes, MeshFormat format, const std::string& name, const ReadBeside& beside = {});

/// The same, the format taken from the content or the extension of `name`.
LoadedMesh read_mesh(std::string_view bytes, const std::string& name, const ReadBeside& beside);

/// An object of the counts by their names, with the scene if the format has one.
Json to_json(const MeshReport& report);

struct WriteOptions {
  bool binary = true;  ///< PLY and STL only; OFF and OBJ are text
};

/// Writes a mesh in the format of the file's extension (.off, .obj, .ply, .stl). Text and binary
/// PLY carry doubles that read back bit for bit; binary STL holds single precision, as the format
/// demands. Throws MeshError when the extension is unknown or a coordinate or count is beyond what the format
/// holds, std::runtime_error when the file cannot be written (see write_whole_file()). Thread safe.
void write_mesh(const std::filesystem::path& file, const Mesh& mesh, const WriteOptions& options = {});

}  // namespace rectilin
