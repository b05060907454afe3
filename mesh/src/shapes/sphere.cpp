// The unit sphere as a stack of rings from pole to pole. The kinds of tessellation differ in how many vertices each
// ring has and where they are; the triangles between the rings are made in the same way.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "shapes/builder.h"
#include "shapes/round.h"

namespace rectilin::shapes {
namespace {

using std::numbers::pi;

/// A sphere of rings with the given sizes at equally spaced latitudes, and two poles.
Mesh sphere_of_rings(const std::vector<int>& sizes) {
  Mesh mesh;
  const auto latitudes = static_cast<double>(sizes.size() + 1);
  std::vector<Ring> rings{add_circle(mesh, 1, 0, -1)};
  for (const int size : sizes) {
    const double angle = pi * static_cast<double>(rings.size()) / latitudes;
    rings.push_back(add_circle(mesh, size, std::sin(angle), -std::cos(angle)));
  }
  rings.push_back(add_circle(mesh, 1, 0, 1));
  add_strips(mesh, rings);
  return mesh;
}

/// Ring sizes for `faces` nearly equal triangles. A ring of n vertices accounts for 2n triangles, so the sizes must add
/// up to faces/2: they are the steps of a rounded cumulative sum.
std::vector<int> even_ring_sizes(int faces) {
  const int vertices = faces / 2;
  const double edge = std::sqrt(8 * pi / (std::sqrt(3.0) * vertices));  // edge length if all triangles were equilateral
  const int rings = std::max(1, static_cast<int>(std::lround(pi / (edge * std::sqrt(0.75)))) - 1);
  std::vector<double> length_up_to{0};
  for (int i = 1; i <= rings; ++i) length_up_to.push_back(length_up_to.back() + std::sin(pi * i / (rings + 1)));
  std::vector<int> sizes;
  int used = 0;
  for (int i = 1; i <= rings; ++i) {
    const auto now = static_cast<int>(std::lround(vertices * (length_up_to[i] / length_up_to.back())));
    sizes.push_back(now - used);
    used = now;
  }
  return sizes;
}

/// Vertex `i` of the ring that is `k` steps from a pole of the octahedron |x| + |y| + |z| = 1, whose edges are cut into
/// `n` parts, at height z and moved onto the sphere. Sines space the vertices along the octahedron's edges equally.
Vector3 octahedral_vertex(int n, int k, int i, double z) {
  const int quarter = k == 0 ? 0 : i / k, along = k == 0 ? 0 : i % k;
  double x = 1.0 * (k - along) / n, y = 1.0 * along / n;
  for (int turn = 0; turn < quarter; ++turn) x = -std::exchange(y, x);
  return (pi / 2 * Vector3(x, y, z)).array().sin().matrix().normalized();
}

Mesh octahedral_sphere(int subdivisions) {
  const int n = 1 << subdivisions;
  Mesh mesh;
  std::vector<Ring> rings;
  for (int level = -n; level <= n; ++level) {
    const int k = n - std::abs(level);
    std::vector<Vector3> points;
    for (int i = 0; i < std::max(1, 4 * k); ++i) points.push_back(octahedral_vertex(n, k, i, 1.0 * level / n));
    rings.push_back(add_ring(mesh, points));
  }
  add_strips(mesh, rings);
  return mesh;
}

}  // namespace

void Tessellation::bind(Parameters& parameters) {
  parameters
      .choice("kind", kind, {{"octahedral", Kind::kOctahedral}, {"latlong", Kind::kLatLong}, {"even", Kind::kEven}},
              "how the surface is divided")
      .integer("subdivisions", subdivisions, 0, 11, "kind=octahedral: 8 * 4^subdivisions triangles")
      .integer("slices", slices, 3, 4096, "kind=latlong: divisions around the axis")
      .integer("stacks", stacks, 2, 4096, "kind=latlong: divisions from pole to pole")
      .integer("faces", faces, 8, kMaxFaces, "kind=even: triangles, rounded down to an even number");
}

Mesh Tessellation::unit_sphere() const {
  const Tessellation defaults;
  const auto expect = [this](Kind owner, bool is_default, const char* what) {
    if (kind != owner && !is_default) throw ParameterError(what);
  };
  expect(Kind::kOctahedral, subdivisions == defaults.subdivisions, "subdivisions is a setting of kind=octahedral");
  expect(Kind::kLatLong, slices == defaults.slices && stacks == defaults.stacks,
         "slices and stacks are settings of kind=latlong");
  expect(Kind::kEven, faces == defaults.faces, "faces is a setting of kind=even");
  switch (kind) {
    case Kind::kOctahedral:
      return octahedral_sphere(subdivisions);
    case Kind::kLatLong:
      return sphere_of_rings(std::vector<int>(static_cast<std::size_t>(stacks - 1), slices));
    case Kind::kEven:
      break;
  }
  return sphere_of_rings(even_ring_sizes(faces));
}

}  // namespace rectilin::shapes
