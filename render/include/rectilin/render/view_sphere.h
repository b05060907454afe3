// The directions a posed mesh is looked at from: geodesic spheres made from the octahedron.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::render {

/// The paper's geodesic spheres (section 7.1, eqs. 29-32): the regular octahedron, each triangle split in four at the
/// middles of its edges, pushed out to the unit sphere, `level` times.
///
///     level        0    1    2     3      4
///     directions   6   18   66   258   1026
///
/// The directions are in the order in which they emerge, so those of a level begin those of the next; the first six
/// are +x, -x, +y, -y, +z, -z. The sphere is as symmetric as the octahedron, bit for bit: each of the 24 rotations of
/// the cube, and the point reflection, takes directions to directions exactly. The tables live as long as the sphere.
class ViewSphere {
 public:
  static constexpr int kHighest = 6;

  /// `level` from 0 to kHighest; else std::invalid_argument.
  explicit ViewSphere(int level);

  /// The sphere of 6, 18, 66, 258, ... directions; std::invalid_argument if there is none of that many.
  static ViewSphere of_size(std::size_t directions);

  int level() const { return level_; }
  std::size_t size() const { return directions_.size(); }

  /// The vertex table: unit vectors that point from the mesh to the viewer.
  std::span<const Vector3> directions() const { return directions_; }

  /// The edge table: direction 6 + i emerged in the middle of the edge between the two directions `edges()[i]`.
  std::span<const std::array<std::uint32_t, 2>> edges() const { return edges_; }

  /// The triangles of this level, counterclockwise seen from outside.
  std::span<const Triangle> faces() const { return faces_; }

  /// opposite()[k] is the direction -directions()[k].
  std::span<const std::uint32_t> opposite() const { return opposite_; }

  /// What the 24 rotations of the cube do, in the order of frame_symmetries(): a mesh turned by D =
  /// frame_symmetries()[i] shows from direction k what it showed from direction p = permutations()[i][k] before, that
  /// is D d_p = d_k. The two pictures may be turned against each other in their plane (roll). On level 0 these are the
  /// paper's Table 1, in another order; on the others they follow by the edge table, as the paper has it.
  std::span<const std::vector<std::uint32_t>> permutations() const { return permutations_; }

 private:
  int level_;
  std::vector<Vector3> directions_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<Triangle> faces_;
  std::vector<std::uint32_t> opposite_;
  std::vector<std::vector<std::uint32_t>> permutations_;
};

}  // namespace rectilin::render
