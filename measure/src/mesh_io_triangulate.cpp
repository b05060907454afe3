#include <algorithm>
#include <cmath>

#include "mesh_triangulate.h"

namespace rectilin {

double unit_scale(const Eigen::AlignedBox3d& box) {
  // Halves, since the full side may overflow. The bound keeps the scale finite for the smallest boxes.
  const double half_side = (0.5 * box.max() - 0.5 * box.min()).maxCoeff();
  constexpr int kSmallestExponent = -1020;
  const int exponent = half_side > 0 ? std::ilogb(half_side) + 1 : 0;
  return std::ldexp(1.0, -std::max(exponent, kSmallestExponent));
}

void PolygonTriangulator::append(const std::vector<Vector3>& vertices,
                                 std::span<const std::uint32_t> polygon,
                                 std::vector<Triangle>& triangles) {
  if (polygon.size() > 3 && project(vertices, polygon) && !fan_keeps_orientation()) {
    clip_ears(polygon, triangles);
    return;
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
}

// Fills points_; false if the polygon has no normal to look along.
bool PolygonTriangulator::project(const std::vector<Vector3>& vertices,
                                  std::span<const std::uint32_t> polygon) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t corner : polygon) box.extend(vertices[corner]);
  const double scale = unit_scale(box);
  const Vector3 origin = scale * vertices[polygon[0]];

  Vector3 normal = Vector3::Zero();  // Newell's: the sum of the fan's area vectors, twice
  Vector3 last = Vector3::Zero();
  for (const std::uint32_t corner : polygon.subspan(1)) {
    const Vector3 point = scale * vertices[corner] - origin;
    normal += last.cross(point);
    last = point;
  }
  int axis = 0;
  if (normal.cwiseAbs().maxCoeff(&axis) == 0) return false;

  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double side = normal[axis] > 0 ? 1.0 : -1.0;
  points_.clear();
  for (const std::uint32_t corner : polygon) {
    const Vector3 point = scale * vertices[corner] - origin;
    points_.emplace_back(point[u], side * point[v]);
  }
  return true;
}

// Twice the signed area of a triangle in the projection, positive if counterclockwise.
double PolygonTriangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const Eigen::Vector2d p = points_[b] - points_[a], q = points_[c] - points_[a];
  return p.x() * q.y() - p.y() * q.x();
}

bool PolygonTriangulator::fan_keeps_orientation() const {
  for (std::uint32_t i = 2; i < points_.size(); ++i) {
    if (turn(0, i - 1, i) < 0) return false;
  }
  return true;
}

void PolygonTriangulator::clip_ears(std::span<const std::uint32_t> polygon,
                                    std::vector<Triangle>& triangles) {
  const auto size = static_cast<std::uint32_t>(polygon.size());
  previous_.resize(size);
  next_.resize(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    previous_[i] = i == 0 ? size - 1 : i - 1;
    next_[i] = i + 1 == size ? 0 : i + 1;
  }
  reflex_.clear();
  is_reflex_.assign(size, 0);
  for (std::uint32_t i = 0; i < size; ++i) update_reflex(i);
  work_left_ = kWorkPerCorner * static_cast<std::int64_t>(size);

  // Round and round until a full turn finds nothing to cut; then, for one cut, with less demand.
  std::uint32_t corner = 0, left = size, visited = 0;
  Cut cut = Cut::kEar;
  while (left > 3 && work_left_ > 0) {
    if (can_cut(corner, cut)) {
      triangles.push_back({polygon[previous_[corner]], polygon[corner], polygon[next_[corner]]});
      unlink(corner);
      --left;
      visited = 0;
      cut = Cut::kEar;
    } else if (++visited == left) {
      if (cut == Cut::kConvex) break;
      cut = cut == Cut::kEar ? Cut::kFlat : Cut::kConvex;
      visited = 0;
    }
    corner = next_[corner];
  }
  for (std::uint32_t i = next_[corner]; next_[i] != corner; i = next_[i]) {
    triangles.push_back({polygon[corner], polygon[i], polygon[next_[i]]});
  }
}

bool PolygonTriangulator::can_cut(std::uint32_t corner, Cut cut) {
  --work_left_;
  const double area = turn_at(corner);
  switch (cut) {
    case Cut::kEar:
      return area > 0 && is_empty(corner);
    case Cut::kFlat:
      return area == 0;
    case Cut::kConvex:
      return area > 0;
  }
  return false;
}

// Whether no reflex corner lies in or on the triangle at a corner.
bool PolygonTriangulator::is_empty(std::uint32_t corner) {
  const std::uint32_t a = previous_[corner], b = corner, c = next_[corner];
  for (std::size_t i = 0; i < reflex_.size();) {
    const std::uint32_t p = reflex_[i];
    if (!is_reflex_[p]) {
      reflex_[i] = reflex_.back();
      reflex_.pop_back();
      continue;
    }
    ++i;
    --work_left_;
    const bool inside = turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    const bool coincides =
        points_[p] == points_[a] || points_[p] == points_[b] || points_[p] == points_[c];
    if (inside && !coincides) return false;
  }
  return true;
}

void PolygonTriangulator::unlink(std::uint32_t corner) {
  const std::uint32_t before = previous_[corner], after = next_[corner];
  next_[before] = after;
  previous_[after] = before;
  is_reflex_[corner] = 0;
  update_reflex(before);
  update_reflex(after);
}

void PolygonTriangulator::update_reflex(std::uint32_t corner) {
  const bool reflex = turn_at(corner) <= 0;
  if (reflex && !is_reflex_[corner]) reflex_.push_back(corner);
  is_reflex_[corner] = reflex;
}

}  // namespace rectilin
