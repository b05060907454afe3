// A triangle mesh as the measure sees it: a soup of triangles in double precision.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace rectilin {

using Vector3 = Eigen::Vector3d;

/// Three indices into Mesh::vertices. Their order (the orientation) does not matter to the measure.
using Triangle = std::array<std::uint32_t, 3>;

/// Triangles that share vertices. Open, non-manifold, inconsistently oriented and degenerate meshes are all legal
/// (paper, section 1, advantage 3). Whoever makes a mesh sees to it that every index is below vertices.size() and every
/// coordinate is finite. Coordinates may be of any scale.
struct Mesh {
  std::vector<Vector3> vertices;
  std::vector<Triangle> triangles;
};

/// What a file with a scene graph (glTF, 3MF) says about the scene as a whole. All are 0 for other formats.
struct SceneReport {
  double metres_per_unit = 0;  ///< the file's unit of length; the mesh has been scaled to metres
  std::size_t instances = 0;   ///< meshes placed in the scene, counted once for each place
  std::size_t skipped = 0;     ///< parts left out: points, lines, or without positions
  std::size_t unplaced = 0;    ///< meshes in the file that the scene does not show, such as supports for printing
  std::size_t deformed = 0;    ///< meshes placed in their pose at rest, because skins and morph targets are not applied
};

/// What a reader found, repaired or left out on the way from a file to a Mesh: counts, and where the first of each kind
/// is. summary() (mesh_report.h) says in one line what was left out.
struct MeshReport {
  std::size_t vertices = 0;               ///< vertex records in the file (STL: three for each triangle)
  std::size_t polygons = 0;               ///< face records in the file, strips counted by triangle
  std::size_t triangulated = 0;           ///< polygons of more than three corners, split into triangles
  std::size_t nonfinite_vertices = 0;     ///< vertices with a NaN or infinite coordinate, removed
  std::size_t dropped_nonfinite = 0;      ///< polygons dropped because they use such a vertex
  std::size_t dropped_short = 0;          ///< face records of fewer than three corners, dropped
  std::size_t degenerate = 0;             ///< triangles of zero area (a repeated index, or too thin for
                                          ///< the mesh's scale), kept: they weigh nothing
  std::size_t duplicate_vertices = 0;     ///< vertices where an earlier one is, kept; none in STL, whose
                                          ///< repeated corners become one vertex
  std::size_t unreferenced_vertices = 0;  ///< vertices that no triangle uses, kept
  std::size_t odd_facets = 0;             ///< STL: facets of other than three corners, treated as polygons
  std::size_t unknown_statements = 0;     ///< statements (OBJ) or elements (PLY) that may be surface, not read
  std::string first_unknown;              ///< the first of them: "'surf' in line 7"
  std::size_t left_over_bytes = 0;        ///< data after everything that the header counts
  std::string left_over_place;            ///< where that data begins: "line 9" or "byte 684"
  std::size_t padding_bytes = 0;          ///< NUL, Ctrl-Z or, in binary files, white space at the end
  SceneReport scene;
};

/// Thrown when a mesh cannot be read, made or measured. what() is one line: "FILE:PLACE: reason", where PLACE is "line
/// N" for text and "byte N" for binary data (counted from 0), or "FILE: reason" where no place applies.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rectilin
