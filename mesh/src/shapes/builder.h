// What surfaces are put together from: rings of vertices, strips between them, caps, and box sides.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::shapes {

/// No shape has more faces than this (about a gigabyte of mesh): a typing error must not take the
/// machine down.
inline constexpr int kMaxFaces = 1 << 25;

/// Lengths that a setting may ask for; their squares and ratios stay far from double's limits.
inline constexpr double kShortest = 1e-3, kLongest = 1e3;

/// Consecutive vertices that run around once, counterclockwise seen from +z. One vertex is a pole.
struct Ring {
  std::uint32_t first, count;

  /// The vertex `i` steps on from the first, around and around.
  std::uint32_t operator[](std::uint32_t i) const { return first + i % count; }
};

Ring add_ring(Mesh& mesh, const std::vector<Vector3>& points);

/// A regular polygon about the z axis, its first vertex over +x; a pole if `count` is 1.
Ring add_circle(Mesh& mesh, int count, double radius, double z);

/// An axis-parallel square about the z axis.
Ring add_square(Mesh& mesh, double side, double z);

/// The triangles between two rings of any sizes, facing away from the axis if `upper` is above
/// `lower`. One triangle for each step on either ring, so lower.count + upper.count of them, none
/// at a pole.
void add_strip(Mesh& mesh, Ring lower, Ring upper);

/// Strips between each ring and the next.
void add_strips(Mesh& mesh, const std::vector<Ring>& rings);

/// Fills a ring with triangles that share its first vertex; it must see all the others.
enum class Facing { kUp, kDown };
void add_cap(Mesh& mesh, Ring ring, Facing facing);

/// A point of an integer lattice.
using LatticePoint = std::array<int, 3>;

/// The surface of a box of cells[0] x cells[1] x cells[2] cells: two triangles for each cell side
/// on it, `place` gives the position of each lattice point on it. No vertex is doubled at edges.
Mesh box_surface(const LatticePoint& cells, const std::function<Vector3(const LatticePoint&)>& place);

}  // namespace rectilin::shapes
