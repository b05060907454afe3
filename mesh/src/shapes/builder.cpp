#include "shapes/builder.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace rectilin::shapes {
namespace {

/// Numbers the lattice points on the surface of a box layer by layer: all points of the bottom and the top layer, only
/// the rim of those in between.
class SurfaceNumbering {
 public:
  explicit SurfaceNumbering(const LatticePoint& cells)
      : nx_(cells[0]), ny_(cells[1]), nz_(cells[2]), full_((nx_ + 1) * (ny_ + 1)), rim_(2 * (nx_ + ny_)) {}

  std::size_t size() const { return static_cast<std::size_t>(2 * full_ + (nz_ - 1) * rim_); }

  std::uint32_t operator()(const LatticePoint& p) const {
    const auto [i, j, k] = p;
    if (k == 0) return static_cast<std::uint32_t>(j * (nx_ + 1) + i);
    const int below = full_ + (k - 1) * rim_;
    return static_cast<std::uint32_t>(below + (k == nz_ ? j * (nx_ + 1) + i : along_rim(i, j)));
  }

 private:
  int along_rim(int i, int j) const {
    if (j == 0) return i;
    if (i == nx_) return nx_ + j;
    if (j == ny_) return nx_ + ny_ + (nx_ - i);
    return 2 * nx_ + ny_ + (ny_ - j);
  }

  int nx_, ny_, nz_, full_, rim_;
};

}  // namespace

Ring add_ring(Mesh& mesh, const std::vector<Vector3>& points) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), points.begin(), points.end());
  return {first, static_cast<std::uint32_t>(points.size())};
}

Ring add_circle(Mesh& mesh, int count, double radius, double z) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const double step = 2 * std::numbers::pi / count;
  for (int i = 0; i < count; ++i)
    mesh.vertices.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step), z);
  return {first, static_cast<std::uint32_t>(count)};
}

Ring add_square(Mesh& mesh, double side, double z) {
  const double half = side / 2;
  return add_ring(mesh, {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

void add_strip(Mesh& mesh, Ring lower, Ring upper) {
  const std::uint64_t m = lower.count, n = upper.count;
  const std::uint64_t lower_steps = m > 1 ? m : 0, upper_steps = n > 1 ? n : 0;
  // The next triangle advances on the ring whose next vertex comes first around the axis: compares (i+1)/m with
  // (j+1)/n. In a tie the smaller ring goes first, which between rings of 4k and 4k+4 vertices gives the regular
  // pattern of an octahedron.
  const auto lower_is_next = [=](std::uint64_t i, std::uint64_t j) {
    if (i == lower_steps || j == upper_steps) return i < lower_steps;
    const std::uint64_t a = (i + 1) * n, b = (j + 1) * m;
    return a < b || (a == b && m <= n);
  };
  for (std::uint32_t i = 0, j = 0; i < lower_steps || j < upper_steps;) {
    if (lower_is_next(i, j)) {
      mesh.triangles.push_back({lower[i], lower[i + 1], upper[j]});
      ++i;
    } else {
      mesh.triangles.push_back({lower[i], upper[j + 1], upper[j]});
      ++j;
    }
  }
}

void add_strips(Mesh& mesh, const std::vector<Ring>& rings) {
  std::size_t steps = 0;
  for (const Ring ring : rings) steps += 2 * static_cast<std::size_t>(ring.count);
  mesh.triangles.reserve(mesh.triangles.size() + steps);
  for (std::size_t i = 1; i < rings.size(); ++i) add_strip(mesh, rings[i - 1], rings[i]);
}

void add_cap(Mesh& mesh, Ring ring, Facing facing) {
  for (std::uint32_t i = 1; i + 1 < ring.count; ++i) {
    const auto [a, b] = facing == Facing::kUp ? std::pair(i, i + 1) : std::pair(i + 1, i);
    mesh.triangles.push_back({ring[0], ring[a], ring[b]});
  }
}

Mesh box_surface(const LatticePoint& cells, const std::function<Vector3(const LatticePoint&)>& place) {
  const SurfaceNumbering number(cells);
  Mesh mesh;
  mesh.vertices.resize(number.size());
  mesh.triangles.reserve(2 * number.size());  // the number of triangles by Euler's formula, plus four
  const auto add_side = [&](int axis, bool far) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    LatticePoint p{};
    p[axis] = far ? cells[axis] : 0;
    const auto at = [&](int i, int j) {
      p[u] = i;
      p[v] = j;
      return number(p);
    };
    for (int j = 0; j <= cells[v]; ++j)
      for (int i = 0; i <= cells[u]; ++i) {
        const std::uint32_t a = at(i, j);
        mesh.vertices[a] = place(p);
        if (i == cells[u] || j == cells[v]) continue;
        std::uint32_t b = at(i + 1, j), d = at(i, j + 1);
        const std::uint32_t c = at(i + 1, j + 1);
        if (!far) std::swap(b, d);
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
  };
  for (int axis = 0; axis < 3; ++axis) {
    add_side(axis, false);
    add_side(axis, true);
  }
  return mesh;
}

}  // namespace rectilin::shapes
