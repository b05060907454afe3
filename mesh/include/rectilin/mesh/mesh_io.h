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
/// OFF (text). Read: the keyword in capitals or small letters, with any of the prefixes ST, C, N, 4 and n, or missing;
///   counts on one line or several, with or without the number of edges; one vertex a line, ignoring further numbers on
///   it; faces on one line or several, ignoring a colour at the end. Reported: anything after the last face, such as
///   another mesh. Refused: OFF BINARY; fewer vertices or faces than the counts say.
/// OBJ. Read: `v`, `f` (`fo` in old files), indices that count from either end, lines continued by a backslash.
///   Ignored: statements that have nothing to do with polygons, such as groups, materials, lines and curves. Reported:
///   all other statements, above all free-form surfaces. Refused: unknown statements that look like vertices or faces,
///   whatever separates their numbers, since a missing vertex would change what all later indices mean; `call`, which
///   asks for another file.
/// PLY (text, and binary of both byte orders). Read: `vertex`, `face` and `tristrips`, each item on one line or
///   several. Ignored: other elements. Reported: other elements that list vertices; anything after the last element.
///   Refused: types that the format does not have, header lines that are not statements, binary files that were copied
///   as text.
/// STL, text. Read: words in the right order, however they are divided into lines; several solids; a single `vertex` in
///   front of all three corners. Each loop of a facet is a polygon. Reported: loops with other than three corners.
///   Refused: any other word, anything after `endsolid`, NUL inside the text.
/// STL, binary. Read: files of 84 + 50 n bytes, where n is the count of triangles that they state, whatever their first
///   80 bytes are. Reported: NUL or white space after that. Refused: any other size; the error says where it may come
///   from (several files in one, a copy made in text mode, more data for each triangle).
///
/// glTF 2.0, text and binary, with buffers in files in the same folder or below it, never elsewhere; 3MF. What is read
///   is the scene that the file shows (or the build that it asks for), with every instance in its place, in metres (see
///   MeshReport::scene). Ignored: points, lines, materials, images. Reported: meshes that the scene does not show, such
///   as supports for printing; meshes whose skin or morph targets are not applied; indices left over after the last
///   triangle; anything after the end of a binary file. Refused: compressed geometry (Draco, meshopt); instances that
///   come to more than 2^25 vertices and triangles; 3MF files that unpack to more than 300 times their size and more
///   than 64 MiB.
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
