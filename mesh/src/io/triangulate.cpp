#include "io/triangulate.h"

#include <algorithm>
#include <cmath>

namespace rectilin {
double unit_scale(const Eigen::AlignedBox3d& box) {
  // Halves, since the full side may overflow. The bound keeps the scale finite for the smallest
  // boxes.
  const double half_side = (0.5 * box.max() - 0.5 * box.min()).maxCoeff();
  constexpr int kSmallestExponent = -1020;
  const int exponent = half_side > 0 ? std::ilogb(half_side) + 1 : 0;
  return std::ldexp(1.0, -std::max(exponent, kSmallestExponent));
}

bool PolygonTriangulator::append(const std::vector<Vector3>& vertices, std::span<const std::uint32_t> polygon,
                                 std::vector<Triangle>& triangles) {
  if (polygon.size() > 3 && project(vertices, polygon) && !fan_keeps_orientation()) {
    return clip_ears(polygon, triangles);
  }
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
  return true;
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

bool PolygonTriangulator::clip_ears(std::span<const std::uint32_t> polygon, std::vector<Triangle>& triangles) {
  const auto size = static_cast<std::uint32_t>(polygon.size());
  previous_.resize(size);
  next_.resize(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    previous_[i] = i == 0 ? size - 1 : i - 1;
    next_[i] = i + 1 == size ? 0 : i + 1;
  }
  find_reflex();
  work_left_ = kWorkPerCorner * static_cast<std::int64_t>(size);

  std::vector<std::uint32_t> waiting;  // corners that may be ears
  std::size_t begin = 0;
  std::uint32_t left = size, corner = 0;  // one that is left
  const auto cut = [&](std::uint32_t i) {
    triangles.push_back({polygon[previous_[i]], polygon[i], polygon[next_[i]]});
    corner = next_[i];
    waiting.insert(waiting.end(), {previous_[i], next_[i]});
    unlink(i);
    --left;
  };
  const auto wait_all = [&] {
    waiting.clear();
    begin = 0;
    for (std::uint32_t i = 0; i < left; ++i, corner = next_[corner]) waiting.push_back(corner);
  };
  wait_all();
  while (left > 3) {
    if (work_left_ <= 0) return false;
    if (begin < waiting.size()) {
      const std::uint32_t i = waiting[begin++];
      --work_left_;
      if (is_left(i) && turn_at(i) > 0 && is_empty(i)) cut(i);
      continue;
    }
    // No ear: straight corners may block each other; else it crosses itself.
    const std::uint32_t before = left;
    for (std::uint32_t i = 0; i < before && left > 3; ++i) {
      const std::uint32_t at = corner;
      corner = next_[at];
      if (turn_at(at) == 0) cut(at);
    }
    work_left_ -= before;
    if (left < before) {
      wait_all();
      continue;
    }
    for (std::uint32_t i = 0; i < left && turn_at(corner) <= 0; ++i) corner = next_[corner];
    if (turn_at(corner) <= 0) break;
    cut(corner);
  }
  for (std::uint32_t i = next_[corner]; next_[i] != corner; i = next_[i]) {
    triangles.push_back({polygon[corner], polygon[i], polygon[next_[i]]});
  }
  return true;
}

void PolygonTriangulator::find_reflex() {
  std::vector<PointTree::Point> reflex;
  is_reflex_.assign(points_.size(), 0);
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    is_reflex_[i] = turn_at(i) <= 0;
    if (is_reflex_[i]) reflex.push_back({points_[i], i});
  }
  reflex_.build(std::move(reflex), static_cast<std::uint32_t>(points_.size()));
}

// Whether no reflex corner lies in or on the triangle at a corner.
bool PolygonTriangulator::is_empty(std::uint32_t corner) {
  const Eigen::Vector2d &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
  return !reflex_.any_in(a, b, c, work_left_, [&](const PointTree::Point& p) {
    return is_reflex_[p.id] && p.place != a && p.place != b && p.place != c;
  });
}

void PolygonTriangulator::unlink(std::uint32_t corner) {
  const std::uint32_t before = previous_[corner], after = next_[corner];
  next_[before] = after;
  previous_[after] = before;
  next_[corner] = corner;
  set_not_reflex(corner);
  for (const std::uint32_t neighbour : {before, after}) {
    if (turn_at(neighbour) > 0) set_not_reflex(neighbour);
  }
}

// A corner of a simple polygon that is not reflex never becomes so by cutting ears.
void PolygonTriangulator::set_not_reflex(std::uint32_t corner) {
  if (is_reflex_[corner]) reflex_.remove(corner);
  is_reflex_[corner] = 0;
}

}  // namespace rectilin
