#include <algorithm>
#include <cmath>

#include "mesh_triangulate.h"

namespace rectilin {
namespace {

// Twice the signed area of a triangle, positive if counterclockwise.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d p = b - a, q = c - a;
  return p.x() * q.y() - p.y() * q.x();
}

}  // namespace

double unit_scale(const Eigen::AlignedBox3d& box) {
  // Halves, since the full side may overflow. The bound keeps the scale finite for the smallest
  // boxes.
  const double half_side = (0.5 * box.max() - 0.5 * box.min()).maxCoeff();
  constexpr int kSmallestExponent = -1020;
  const int exponent = half_side > 0 ? std::ilogb(half_side) + 1 : 0;
  return std::ldexp(1.0, -std::max(exponent, kSmallestExponent));
}

void PolygonTriangulator::append(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon,
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
bool PolygonTriangulator::project(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon) {
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

double PolygonTriangulator::turn_at(std::uint32_t corner) const {
  return turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

bool PolygonTriangulator::fan_keeps_orientation() const {
  for (std::uint32_t i = 2; i < points_.size(); ++i) {
    if (turn(points_[0], points_[i - 1], points_[i]) < 0) return false;
  }
  return true;
}

void PolygonTriangulator::clip_ears(std::span<const std::uint32_t> polygon, std::vector<Triangle>& triangles) {
  const auto size = static_cast<std::uint32_t>(polygon.size());
  previous_.resize(size);
  next_.resize(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    previous_[i] = i == 0 ? size - 1 : i - 1;
    next_[i] = i + 1 == size ? 0 : i + 1;
  }
  find_reflex();
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

void PolygonTriangulator::find_reflex() {
  reflex_.clear();
  is_reflex_.assign(points_.size(), 0);
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    is_reflex_[i] = turn_at(i) <= 0;
    if (is_reflex_[i]) reflex_.push_back({points_[i], i});
  }
  reflex_count_ = reflex_.size();
  std::sort(reflex_.begin(), reflex_.end(), [](const ReflexCorner& p, const ReflexCorner& q) {
    return p.point.x() != q.point.x() ? p.point.x() < q.point.x() : p.corner < q.corner;
  });
}

// Whether no reflex corner lies in or on the triangle at a corner.
bool PolygonTriangulator::is_empty(std::uint32_t corner) {
  const Eigen::Vector2d &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
  const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
  const auto begin = std::lower_bound(reflex_.begin(), reflex_.end(), left,
                                      [](const ReflexCorner& p, double x) { return p.point.x() < x; });
  for (auto p = begin; p != reflex_.end() && p->point.x() <= right; ++p) {
    --work_left_;
    const Eigen::Vector2d& q = p->point;
    const bool inside = turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
    if (inside && is_reflex_[p->corner] && q != a && q != b && q != c) return false;
  }
  return true;
}

void PolygonTriangulator::unlink(std::uint32_t corner) {
  const std::uint32_t before = previous_[corner], after = next_[corner];
  next_[before] = after;
  previous_[after] = before;
  set_not_reflex(corner);
  for (const std::uint32_t neighbour : {before, after}) {
    if (turn_at(neighbour) > 0) set_not_reflex(neighbour);
  }
}

// A corner of a simple polygon that is not reflex never becomes so by cutting ears.
void PolygonTriangulator::set_not_reflex(std::uint32_t corner) {
  reflex_count_ -= is_reflex_[corner] ? 1 : 0;
  is_reflex_[corner] = 0;
  if (2 * reflex_count_ < reflex_.size()) {
    std::erase_if(reflex_, [&](const ReflexCorner& p) { return !is_reflex_[p.corner]; });
  }
}

}  // namespace rectilin
