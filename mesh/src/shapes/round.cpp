#include "shapes/round.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/builder.h"

namespace rectilin::shapes {

void Sphere::bind(Parameters& parameters) {
  parameters.real("radius", radius, kShortest, kLongest, "radius");
  tessellation.bind(parameters);
}

Mesh Sphere::build() const {
  Mesh mesh = tessellation.unit_sphere();
  for (auto& p : mesh.vertices) p *= radius;
  return mesh;
}

void Ellipsoid::bind(Parameters& parameters) {
  parameters.real("a", a, kShortest, kLongest, "semi-axis along x")
      .real("b", b, kShortest, kLongest, "semi-axis along y")
      .real("c", c, kShortest, kLongest, "semi-axis along z");
  tessellation.bind(parameters);
}

Mesh Ellipsoid::build() const {
  Mesh mesh = tessellation.unit_sphere();
  for (auto& p : mesh.vertices) p = p.cwiseProduct(Vector3(a, b, c));
  return mesh;
}

void Torus::bind(Parameters& parameters) {
  parameters.real("major", major, kShortest, kLongest, "radius of the circle in the tube's middle")
      .real("minor", minor, kShortest, kLongest, "radius of the tube, less than major")
      .integer("slices", slices, 3, 4096, "divisions around the axis")
      .integer("stacks", stacks, 3, 4096, "divisions around the tube");
}

Mesh Torus::build() const {
  if (minor >= major) throw ParameterError("minor must be less than major");
  Mesh mesh;
  std::vector<Ring> rings;
  for (int i = 0; i < stacks; ++i) {
    const double angle = 2 * std::numbers::pi * i / stacks;
    rings.push_back(add_circle(mesh, slices, major + minor * std::cos(angle), minor * std::sin(angle)));
  }
  rings.push_back(rings.front());
  add_strips(mesh, rings);
  return mesh;
}

void FilletedCube::bind(Parameters& parameters) {
  parameters.real("radius", radius, 0, 0.5, "radius of the edges; 0 is the unit cube, 0.5 a sphere")
      .integer("segments", segments, 1, 800, "divisions of an eighth of a circle");
}

/// A rounded cube is the set of points within `radius` of a smaller cube, the core. The surface is a lattice on a cube.
/// Each lattice coordinate stands for a coordinate of the core and for the tangent of the normal's angle, so the normal
/// at a lattice point is (t_x, t_y, t_z) up to length, with one of the three -1 or 1.
Mesh FilletedCube::build() const {
  constexpr double kTooSmall = 1e-6;  // for a picture, and for accurate division in double precision
  const bool is_rounded = radius > kTooSmall, is_flat = radius < 0.5 - kTooSmall;
  const double r = !is_rounded ? 0 : is_flat ? radius : 0.5;
  const double core = 0.5 - r;
  struct Line {
    double core, tangent;
  };
  std::vector<Line> lines;
  const auto tangent = [&](int i) { return std::tan(std::numbers::pi / 4 * i / segments); };
  if (is_rounded)
    for (int i = segments; i > 0; --i) lines.push_back({-core, -tangent(i)});
  lines.push_back({-core, 0});
  if (is_flat) lines.push_back({core, 0});
  if (is_rounded)
    for (int i = 1; i <= segments; ++i) lines.push_back({core, tangent(i)});

  const int cells = static_cast<int>(lines.size()) - 1;
  return box_surface({cells, cells, cells}, [&](const LatticePoint& p) -> Vector3 {
    const Line &x = lines[p[0]], &y = lines[p[1]], &z = lines[p[2]];
    return Vector3(x.core, y.core, z.core) +
           r * Vector3(x.tangent, y.tangent, z.tangent).normalized();  // zero stays zero
  });
}

}  // namespace rectilin::shapes
