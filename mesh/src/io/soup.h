// What every reader makes of a file before it is a mesh: polygons over vertices, as they were read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "rectilin/mesh/mesh_io.h"

namespace rectilin {

/// Polygon k has the corners from the end of polygon k - 1 (or 0) to its own end. Corners are below
/// vertices.size(); coordinates may be NaN or infinite and polygons may have any number of corners.
struct PolygonSoup {
  std::vector<Vector3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;
  SceneReport scene;
  bool weld = false;  ///< the format cannot share vertices, so equal positions become one vertex
  MeshReport report;  ///< what the reader of the format has to say

  /// Ends the polygon whose corners were appended last.
  void close_polygon() { ends.push_back(corners.size()); }
};

/// Readers of one format. `name` stands for the file in errors.
PolygonSoup read_off(std::string_view bytes, const std::string& name);
PolygonSoup read_obj(std::string_view bytes, const std::string& name);
PolygonSoup read_ply(std::string_view bytes, const std::string& name);
PolygonSoup read_stl(std::string_view bytes, const std::string& name);
PolygonSoup read_gltf(std::string_view bytes, const ReadBeside& beside, const std::string& name);
PolygonSoup read_3mf(std::string_view bytes, const std::string& name);

/// Whether bytes are of a format by their content.
bool looks_like_off(std::string_view bytes);
bool looks_like_obj(std::string_view bytes);  ///< by its first statement: weak evidence
bool looks_like_ply(std::string_view bytes);
bool looks_like_stl(std::string_view bytes);
bool looks_like_glb(std::string_view bytes);
bool looks_like_3mf(std::string_view bytes);
/// Whether bytes are a binary STL file to the last byte: its first 80 bytes may look like anything.
bool is_binary_stl(std::string_view bytes);

/// Turns a soup into a mesh: drops what cannot be kept, triangulates, counts, and refuses meshes
/// without area.
LoadedMesh assemble(PolygonSoup soup, const std::string& name);

}  // namespace rectilin
