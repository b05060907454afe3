// Building blocks of surfaces: rings of vertices, strips of triangles between them, caps, and the sides of boxes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::shapes {

/// The largest number of faces of any shape (about a gigabyte of mesh), so that a typing error does not exhaust
/// the memory.
inline constexpr int kMaxFaces = 1 << 25;

/// The range of lengths that settings accept. Their squares and ratios stay far from the limits of double precision.
inline constexpr double kShortest = 1e-3, kLongest = 1e3;

/// Consecutive vertices that form a closed ring, counterclockwise seen from +z. A ring of one vertex is a pole.
struct Ring {
  std::uint32_t first, count;

  /// The vertex `i` steps from the first one, going round as often as needed.
  std::uint32_t operator[](std::uint32_t i) const { return first + i % count; }
};

Ring add_ring(Mesh& mesh, const std::vector<Vector3>& points);

/// A regular polygon about the z axis, its first vertex over +x; a pole if `count` is 1.
Ring add_circle(Mesh& mesh, int count, double radius, double z);

/// An axis-parallel square about the z axis.
Ring add_square(Mesh& mesh, double side, double z);

/// Adds the triangles between two rings of any sizes, facing away from the axis if `upper` is above `lower`. There is
/// one triangle for each step on either ring, lower.count + upper.count in all; a pole has no steps.
void add_strip(Mesh& mesh, Ring lower, Ring upper);

/// Adds a strip between each ring and the next.
void add_strips(Mesh& mesh, const std::vector<Ring>& rings);

/// Fills a ring with triangles that share its first vertex, from which all others must be visible.
enum class Facing { kUp, kDown };
void add_cap(Mesh& mesh, Ring ring, Facing facing);

/// A point with integer coordinates.
using LatticePoint = std::array<int, 3>;

/// The surface of a box of cells[0] x cells[1] x cells[2] cells: two triangles for each side of a cell that lies on it.
/// `place` gives the position of each lattice point. Vertices on edges are not duplicated.
Mesh box_surface(const LatticePoint& cells, const std::function<Vector3(const LatticePoint&)>& place);

}  // namespace rectilin::shapes
