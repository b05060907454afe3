#include "surface_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rectilin::search {
namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles that are no longer divided

double squared_distance(const Vector3& p, const Vector3& low, const Vector3& high) {
  return (p - p.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

}  // namespace

// Ericson, Real-Time Collision Detection, section 5.1.5. Sides without length are passed over, so that triangles
// without area, of which files have many, are the segments or points that they are.
Vector3 nearest_of_triangle(const Vector3& p, const SurfaceTree::Corners& t) {
  const Vector3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const Vector3 bp = p - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return t[0] + d1 / (d1 - d3) * ab;
  const Vector3 cp = p - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return t[0] + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6 && d4 - d3 + d5 - d6 > 0)
    return t[1] + (d4 - d3) / (d4 - d3 + d5 - d6) * (t[2] - t[1]);
  const double sum = va + vb + vc;
  return sum > 0 ? Vector3(t[0] + vb / sum * ab + vc / sum * ac) : t[0];
}

SurfaceTree::SurfaceTree(const std::vector<Corners>& triangles) {
  std::vector<std::uint32_t> order(triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  nodes_.reserve(triangles.size());
  if (!order.empty()) build(triangles, order, 0, static_cast<std::uint32_t>(order.size()));
  triangles_.reserve(order.size());
  for (const std::uint32_t t : order) triangles_.push_back(triangles[t]);
}

std::uint32_t SurfaceTree::build(const std::vector<Corners>& triangles, std::vector<std::uint32_t>& order,
                                 std::uint32_t begin, std::uint32_t end) {
  const auto own = static_cast<std::uint32_t>(nodes_.size());
  Node node{triangles[order[begin]][0], triangles[order[begin]][0], begin, end};
  for (std::uint32_t i = begin; i < end; ++i)
    for (const Vector3& corner : triangles[order[i]]) {
      node.low = node.low.cwiseMin(corner);
      node.high = node.high.cwiseMax(corner);
    }
  nodes_.push_back(node);
  if (end - begin <= kLeaf) return own;
  int axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto middle_of = [&](std::uint32_t t) {
    return triangles[t][0](axis) + triangles[t][1](axis) + triangles[t][2](axis);
  };
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(
      order.begin() + begin, order.begin() + half, order.begin() + end,
      [&](std::uint32_t a, std::uint32_t b) { return std::pair(middle_of(a), a) < std::pair(middle_of(b), b); });
  build(triangles, order, begin, half);
  const std::uint32_t far = build(triangles, order, half, end);
  nodes_[own].far = far;
  return own;
}

SurfaceTree::Foot SurfaceTree::nearest(const Vector3& p, double within, std::uint32_t guess) const {
  Foot foot{p};
  if (nodes_.empty()) return foot;
  double limit = within * within;
  const auto look_at = [&](std::uint32_t triangle) {
    const Vector3 q = nearest_of_triangle(p, triangles_[triangle]);
    const double d = (q - p).squaredNorm();
    if (!(d < limit)) return;
    limit = d;
    foot = {q, 0, triangle};
  };
  if (guess < triangles_.size()) look_at(guess);
  std::array<std::pair<double, std::uint32_t>, 64> open;  // a median divides: the depth is at most 32
  std::size_t count = 0;
  open[count++] = {squared_distance(p, nodes_[0].low, nodes_[0].high), 0};
  while (count > 0) {
    const auto [distance, at] = open[--count];
    if (!(distance < limit)) continue;
    const Node& node = nodes_[at];
    if (node.far == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) look_at(i);
      continue;
    }
    const double near = squared_distance(p, nodes_[at + 1].low, nodes_[at + 1].high);
    const double far = squared_distance(p, nodes_[node.far].low, nodes_[node.far].high);
    const bool first = near <= far;  // the nearer child is visited first
    open[count++] = first ? std::pair(far, node.far) : std::pair(near, at + 1);
    open[count++] = first ? std::pair(near, at + 1) : std::pair(far, node.far);
  }
  if (limit < within * within) foot.distance = std::sqrt(limit);
  else foot.distance = std::numeric_limits<double>::infinity();
  return foot;
}

}  // namespace rectilin::search
