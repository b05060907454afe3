// Reads meshes from files (OFF, OBJ, PLY, STL, glTF and 3MF) and writes them (the first four).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

struct LoadedMesh {
  Mesh mesh;
  MeshReport report;
};

enum class MeshFormat { kOff, kObj, kPly, kStl, kGltf, k3mf };

/// The format that a file's extension names: .off, .obj, .ply, .stl, .gltf, .glb or .3mf, in small letters or capitals.
std::optional<MeshFormat> format_of_extension(const std::filesystem::path& file);

/// Reads a mesh from a file or a pipe. The content tells the format or, where it does not, the extension. The caller
/// gets the whole mesh of the file, or a report that says what was left out (see summary()), or an error. Throws
/// MeshError for anything malformed: an index out of range, a truncated file, counts that the file cannot hold, no
/// triangle, zero total area. Files of another kind are refused, and the error says what they are: archives, programs,
/// web pages, placeholders of version control. Thread safe.
///
/// Text files may have any line endings and a UTF-8 byte order mark; NUL or Ctrl-Z at their end is reported. `#` hides
/// the rest of a line. Numbers may be "nan", "inf", "1.#IND" and the like: vertices that are not finite are dropped
/// together with their faces, and reported, as are faces of fewer than three corners.
///
/// OFF (text). Read: the keyword in capitals or small letters with any of the prefixes ST, C, N, 4 and n, or left out;
///   counts on one line or several, the number of edges or not; a vertex a line, with whatever numbers stand behind
///   its coordinates; a face on a line or over several, with a colour behind it. Reported: what follows the last face,
///   another mesh for one. Refused: OFF BINARY; fewer vertices or faces than the counts say.
/// OBJ. Read: `v`, `f` (`fo` in old files), indices from either end, lines continued by a backslash. Passed over:
///   statements that say nothing of polygons, such as groups, materials, lines and curves. Reported: all others, above
///   all free-form surfaces. Refused: unknown statements that look like vertices or faces, since a vertex less changes
///   what all later indices mean, whatever separates their numbers; `call`, which asks for another file.
/// PLY (text, binary of both byte orders). Read: `vertex`, `face` and `tristrips`, one element a line or over several.
///   Passed over: other elements. Reported: those of them that list vertices; what follows the last element. Refused:
///   values that the header does not know, header lines that are no statement, binary files copied as text.
/// STL, text. Read: words in their order whatever lines they stand on; several solids; one `vertex` before all three.
///   Each loop of a facet is a polygon. Reported: those of other than three corners. Refused: any other word, what
///   follows `endsolid`, NUL within the text.
/// STL, binary. Read: files of 84 + 50 n bytes, n their count of triangles, whatever their first 80 bytes are.
///   Reported: NUL or white space behind that. Refused: any other size, with what it may come from (several files in
///   one, a copy in text mode, more data behind each triangle).
///
/// glTF 2.0, text and binary, with the buffers in files beside it and below (never elsewhere); 3MF. The scene is read:
///   what it shows, or is to be built, with every instance in its place, in metres (see MeshReport::scene). Passed
///   over: points, lines, materials, images. Reported: meshes that the scene does not show, a printer's supports among
///   them; meshes whose skin or morph targets are not applied; indices that are left over behind the last triangle;
///   what follows the end of a binary file. Refused: a compression of the geometry (Draco, meshopt); instances that
///   come to more than 2^25 vertices and triangles; 3MF that unpacks to more than 300 times its size and 64 MiB.
///
/// A polygon is split into a fan of triangles or, where the fan would fold over itself, by clipping ears, so that a
/// planar concave polygon keeps its area. Both look at the polygon along the coordinate axis nearest to its normal. A
/// polygon of many thousand corners may be so intricate, or cross itself so often, that splitting it would take too
/// long; such a file is refused.
///
/// Time grows with the file's size, times its logarithm at most, and memory is a small multiple of that size, whatever
/// a header claims.
LoadedMesh read_mesh(const std::filesystem::path& file);

/// Returns the bytes of another file by its path relative to a mesh file, in the same folder or below it.
/// Throws MeshError.
using ReadBeside = std::function<std::string(const std::string& path)>;

/// The same for bytes in memory; `name` is what errors call the file. Without `beside` no other file is read.
LoadedMesh read_mesh(std::string_view bytes, MeshFormat format, const std::string& name, const ReadBeside& beside = {});

/// The same with the format taken from the content or from the extension of `name`.
LoadedMesh read_mesh(std::string_view bytes, const std::string& name, const ReadBeside& beside);

struct WriteOptions {
  bool binary = true;     ///< PLY and STL only; OFF and OBJ are text
  bool recentre = false;  ///< moves the middle of the mesh's bounding box to the origin
};

/// Writes a mesh in the format of the file's extension (.off, .obj, .ply, .stl). Text and binary PLY hold doubles,
/// which read back bit for bit. Binary STL holds single precision, as the format demands. Where that changes the
/// triangles' area vectors by more than 1/1000 of the mesh's area in total, because the mesh is small and far from the
/// origin or its coordinates are too small, the mesh is refused; from 1e-5 on the returned line says by how much R and
/// the area may have changed. Otherwise the line is empty. Throws MeshError for such a refusal, for an unknown
/// extension and for coordinates or counts beyond what the format holds, and std::runtime_error if the file cannot be
/// written (see write_whole_file()). Thread safe.
std::string write_mesh(const std::filesystem::path& file, const Mesh& mesh, const WriteOptions& options = {});

/// The bytes of such a file; `name` is what errors call it.
std::string mesh_bytes(const Mesh& mesh, MeshFormat format, const WriteOptions& options, const std::string& name);

}  // namespace rectilin
