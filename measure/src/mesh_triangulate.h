// Polygons into triangles.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "rectilin/measure/mesh.h"

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
/// 1975): only reflex corners can lie in an ear, and they are kept sorted, so that few are looked
/// at. Corners that coincide, as where a channel joins a hole to the outline, do not block each
/// other.
///
/// Cost is O(n) for fans; for ears O(n log n) as long as ears are narrow, in the worst case
/// kWorkPerCorner * n corners looked at, past which the rest of the polygon becomes a fan. A
/// polygon that crosses itself has no area of its own to keep: it is cut at convex corners while
/// there are any.
class PolygonTriangulator {
 public:
  static constexpr std::int64_t kWorkPerCorner = 1000;

  /// Appends the triangles. All corners must be valid indices of finite vertices, at least three.
  void append(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon,
              std::vector<Triangle>& triangles);

 private:
  enum class Cut { kEar, kFlat, kConvex };
  struct ReflexCorner {
    Eigen::Vector2d point;
    std::uint32_t corner;
  };

  bool project(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon);
  bool fan_keeps_orientation() const;
  void clip_ears(std::span<const std::uint32_t> polygon, std::vector<Triangle>& triangles);
  bool can_cut(std::uint32_t corner, Cut cut);
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
  std::vector<ReflexCorner> reflex_;  // by x: the reflex corners, and no more that once were
  std::size_t reflex_count_ = 0;
  std::int64_t work_left_ = 0;
};

}  // namespace rectilin
