// A cube from which everything beyond a plane is cut off. Each side is clipped as a convex polygon.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "shapes/builder.h"
#include "shapes/solids.h"

namespace rectilin::shapes {
namespace {

/// Corners this close to the plane count as lying on it, so that rounding makes no slivers.
constexpr double kOnPlane = 1e-12;

/// Corner `i` of the unit cube about the origin: bit b of i says on which side it is along axis b.
Vector3 corner(int i) { return {(i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5}; }

/// The four corners of a side, counterclockwise seen from outside.
std::array<int, 4> side(int axis, bool far) {
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = far ? 1 << axis : 0;
  return far ? std::array{base, base | u, base | u | v, base | v} : std::array{0, v, u | v, u};
}

class Cut {
 public:
  /// Keeps the part of the unit cube with normal . p <= offset.
  Cut(const Vector3& normal, double offset) {
    for (int i = 0; i < 8; ++i) {
      height_[i] = normal.dot(corner(i)) - offset;
      if (std::abs(height_[i]) < kOnPlane) height_[i] = 0;
    }
  }

  Mesh build() {
    for (int axis = 0; axis < 3; ++axis)
      for (const bool far : {false, true}) add_polygon(clip(side(axis, far)));
    // A plane that only touches the cube leaves no hole, though edges may lie on it.
    if (std::any_of(height_.begin(), height_.end(), [](double h) { return h > 0; })) close();
    return std::move(mesh_);
  }

 private:
  std::vector<std::uint32_t> clip(const std::array<int, 4>& corners) {
    std::vector<std::uint32_t> polygon;
    for (int i = 0; i < 4; ++i) {
      const int a = corners[i], b = corners[(i + 1) % 4];
      if (height_[a] <= 0) polygon.push_back(vertex(a, a));
      if (height_[a] * height_[b] < 0) polygon.push_back(vertex(std::min(a, b), std::max(a, b)));
    }
    return polygon;
  }

  /// The vertex where the plane cuts the edge from corner a to b; the corner itself if a is b.
  std::uint32_t vertex(int a, int b) {
    const auto [at, is_new] = numbers_.try_emplace({a, b}, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      const double t = a == b ? 0 : height_[a] / (height_[a] - height_[b]);
      mesh_.vertices.push_back((1 - t) * corner(a) + t * corner(b));
      on_plane_.push_back(a != b || height_[a] == 0);
    }
    return at->second;
  }

  void add_polygon(const std::vector<std::uint32_t>& polygon) {
    if (polygon.size() < 3) return;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      mesh_.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::uint32_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (on_plane_[a] && on_plane_[b]) rim_[b] = a;
    }
  }

  /// Adds the new side. Its edges are those of the clipped sides that lie on the plane, in the opposite direction.
  void close() {
    std::vector<std::uint32_t> polygon;
    const std::uint32_t start = rim_.begin()->first;
    std::uint32_t at = start;
    do {
      polygon.push_back(at);
      at = rim_.at(at);
    } while (at != start);
    add_polygon(polygon);
  }

  std::array<double, 8> height_;  ///< height of each corner above the plane
  Mesh mesh_;
  std::vector<bool> on_plane_;                            ///< whether each vertex is on the plane
  std::map<std::pair<int, int>, std::uint32_t> numbers_;  ///< numbers of the vertices, by the edge that each is on
  std::map<std::uint32_t, std::uint32_t> rim_;            ///< for each vertex of the cut the next one
};

}  // namespace

void CutCube::bind(Parameters& parameters) {
  parameters.vector3("direction", direction, -kLongest, kLongest, "direction in which parts are cut off");
  parameters.real("depth", depth, 0, 0.99, "part of the width in that direction that is cut off");
}

Mesh CutCube::build() const {
  const Vector3 normal = Vector3(direction.data()).stableNormalized();
  if (normal.isZero(0)) throw ParameterError("direction must not be zero");
  return Cut(normal, normal.lpNorm<1>() * (0.5 - depth)).build();
}

}  // namespace rectilin::shapes
