// Polygons into triangles.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "io/point_tree.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// A power of two that brings the box's longest side into [1, 2), so that products of scaled
/// differences neither overflow nor underflow; scaling by it rounds nothing. The box must not be
/// empty.
double unit_scale(const Eigen::AlignedBox3d& box);

/// Splits polygons into triangles over the same vertices, n - 2 for n corners.
///
/// Seen along the coordinate axis nearest to the polygon's normal, the fan from the first corner is
/// taken if none of its triangles turns against the polygon; that holds for all convex polygons and
/// is what makes the triangles' areas add up to the polygon's. Else ears are clipped (Meisters
/// 1975): only reflex corners can lie in an ear, and they are kept in a tree, so that few are looked
/// at. A corner that is no ear becomes one only when a neighbour is cut, so each is tried a few times. Corners that
/// coincide, as where a channel joins a hole to the outline, do not block each other.
///
/// Cost is O(n) for fans, about O(n log n) for ears, at most kWorkPerCorner * n corners and nodes of the tree looked
/// at. A polygon that crosses itself has no area of its own to keep: it is cut at convex corners while there are any.
class PolygonTriangulator {
 public:
  static constexpr std::int64_t kWorkPerCorner = 1000;

  /// Appends the triangles; false if the work allowed is not enough for them. All corners must be valid indices of
  /// finite vertices, at least three.
  bool append(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon,
              std::vector<Triangle>& triangles);

 private:
  bool project(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon);
  bool fan_keeps_orientation() const;
  bool clip_ears(std::span<const std::uint32_t> polygon, std::vector<Triangle>& triangles);
  bool is_left(std::uint32_t corner) const { return next_[corner] != corner; }
  bool is_empty(std::uint32_t corner);
  void unlink(std::uint32_t corner);
  void find_reflex();
  void set_not_reflex(std::uint32_t corner);
  double turn_at(std::uint32_t corner) const;

  // Of the polygon in hand, by corner: position in the projection (counterclockwise), neighbours
  // among the corners not yet cut, and whether it is one of those and reflex (or straight).
  std::vector<Eigen::Vector2d> points_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<char> is_reflex_;
  PointTree reflex_;
  std::int64_t work_left_ = 0;
};

}  // namespace rectilin
