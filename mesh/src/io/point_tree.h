// Points in the plane, found by triangle and taken away one by one.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <vector>

namespace rectilin {

/// Twice the signed area of a triangle, positive if counterclockwise.
inline double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d p = b - a, q = c - a;
  return p.x() * q.y() - p.y() * q.x();
}

/// A balanced k-d tree (Bentley 1975) that knows how many of a node's points are left. A thin triangle meets few nodes
/// however far it reaches, and nodes without points are passed over.
class PointTree {
 public:
  struct Point {
    Eigen::Vector2d place;
    std::uint32_t id;
  };

  /// Ids are below `ids`. Coordinates are at most 4 in size.
  void build(std::vector<Point> points, std::uint32_t ids) {
    points_ = std::move(points);
    nodes_.clear();
    leaf_of_.assign(ids, 0);
    if (!points_.empty()) add_node(0, static_cast<std::uint32_t>(points_.size()), 0);
  }

  /// A point of the tree, once.
  void remove(std::uint32_t id) {
    std::uint32_t node = leaf_of_[id];
    for (; node != 0; node = nodes_[node].parent) --nodes_[node].left;
    --nodes_[0].left;
  }

  /// Is `blocks` true of any point in or on the counterclockwise triangle? It tells whether a point is still there,
  /// too. Each node and point looked at counts for `work`.
  template <class Blocks>
  bool any_in(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, std::int64_t& work,
              const Blocks& blocks) const {
    return !nodes_.empty() && any_below(0, a, b, c, work, blocks);
  }

 private:
  static constexpr std::uint32_t kLeaf = 8;

  struct Node {
    Eigen::AlignedBox2d box;
    std::uint32_t begin, end, left, parent, second;  // children follow at once and at `second`; 0 for a leaf
  };

  std::uint32_t add_node(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Eigen::AlignedBox2d box;
    for (std::uint32_t i = begin; i < end; ++i) box.extend(points_[i].place);
    nodes_.push_back({box, begin, end, end - begin, parent, 0});
    if (end - begin <= kLeaf) {
      for (std::uint32_t i = begin; i < end; ++i) leaf_of_[points_[i].id] = index;
      return index;
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    const int axis = box.sizes().x() < box.sizes().y() ? 1 : 0;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [axis](const Point& p, const Point& q) {
                       return p.place[axis] != q.place[axis] ? p.place[axis] < q.place[axis] : p.id < q.id;
                     });
    add_node(begin, middle, index);
    const std::uint32_t second = add_node(middle, end, index);
    nodes_[index].second = second;
    return index;
  }

  /// Are all four corners outside the edge, by more than rounding?
  static bool outside(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d inwards(a.y() - b.y(), b.x() - a.x());
    const Eigen::Vector2d furthest = (inwards.array() > 0).select(box.max(), box.min());
    return inwards.dot(furthest - a) < -1e-13;
  }

  template <class Blocks>
  bool any_below(std::uint32_t index, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                 std::int64_t& work, const Blocks& blocks) const {
    const Node& node = nodes_[index];
    --work;
    if (node.left == 0 || outside(node.box, a, b) || outside(node.box, b, c) || outside(node.box, c, a)) return false;
    if (node.second != 0)
      return any_below(index + 1, a, b, c, work, blocks) || any_below(node.second, a, b, c, work, blocks);
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      --work;
      const Eigen::Vector2d& q = points_[i].place;
      if (turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0 && blocks(points_[i])) return true;
    }
    return false;
  }

  std::vector<Point> points_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  // by id
};

}  // namespace rectilin
