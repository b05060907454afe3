// The point of a surface that is nearest to another point.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::search {

/// A soup of triangles in a tree of boxes. Exact, up to rounding; const members are thread safe.
class SurfaceTree {
 public:
  using Corners = std::array<Vector3, 3>;
  explicit SurfaceTree(const std::vector<Corners>& triangles);

  static constexpr std::uint32_t kNoGuess = std::numeric_limits<std::uint32_t>::max();
  struct Foot {
    Vector3 point;
    double distance = std::numeric_limits<double>::infinity();  ///< from the point asked for
    std::uint32_t triangle = kNoGuess;  ///< for normal()
  };
  /// The nearest point of the surface that is nearer than `within`; infinitely far if there is none. A triangle that is
  /// near, such as the last one of a point that has moved a little, makes it quicker and nothing else.
  Foot nearest(const Vector3& p, double within = std::numeric_limits<double>::infinity(),
               std::uint32_t guess = kNoGuess) const;

  /// Of unit length; zero for a triangle without area.
  Vector3 normal(std::uint32_t triangle) const {
    const Corners& t = triangles_[triangle];
    return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  }

 private:
  struct Node {
    Vector3 low, high;
    std::uint32_t begin, end;  ///< of triangles_, if it is a leaf
    std::uint32_t far = 0;     ///< the second child, the first follows its parent; 0: a leaf
  };
  std::uint32_t build(const std::vector<Corners>& triangles, std::vector<std::uint32_t>& order, std::uint32_t begin,
                      std::uint32_t end);

  std::vector<Corners> triangles_;  ///< leaf by leaf
  std::vector<Node> nodes_;
};

/// The point of a triangle nearest to p (Ericson 2004, section 5.1.5).
Vector3 nearest_of_triangle(const Vector3& p, const SurfaceTree::Corners& t);

}  // namespace rectilin::search
