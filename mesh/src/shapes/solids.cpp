#include "shapes/solids.h"

#include <algorithm>
#include <vector>

#include "shapes/builder.h"

namespace rectilin::shapes {
namespace {

void bind_length(Parameters& parameters, const char* name, double& length, const char* help) {
  parameters.real(name, length, kShortest, kLongest, help);
}

void bind_extents(Parameters& parameters, double& x, double& y, double& z) {
  bind_length(parameters, "x", x, "extent along x");
  bind_length(parameters, "y", y, "extent along y");
  bind_length(parameters, "z", z, "extent along z");
}

/// The finest division of a box into nearly cubic cells for which the surface has at most `faces` triangles.
LatticePoint divide_box(const Vector3& size, int faces) {
  const auto cells = [&](double per_length) {
    LatticePoint n;
    for (int axis = 0; axis < 3; ++axis) n[axis] = std::max(1, static_cast<int>(size[axis] * per_length));
    return n;
  };
  double fits = 0, too_fine = faces / size.maxCoeff();
  for (int i = 0; i < 64; ++i) {
    const double middle = (fits + too_fine) / 2;
    const auto n = cells(middle);
    const double triangles = 4.0 * n[0] * n[1] + 4.0 * n[1] * n[2] + 4.0 * n[2] * n[0];
    (triangles <= faces ? fits : too_fine) = middle;
  }
  return cells(fits);
}

/// The solid between a polygon at z = 0 and a copy of it at `height`. The corners run counterclockwise, and all must be
/// visible from the first one.
Mesh extrude(std::vector<Vector3> polygon, double height) {
  Mesh mesh;
  const Ring bottom = add_ring(mesh, polygon);
  for (auto& corner : polygon) corner.z() = height;
  const Ring top = add_ring(mesh, polygon);
  add_strip(mesh, bottom, top);
  add_cap(mesh, bottom, Facing::kDown);
  add_cap(mesh, top, Facing::kUp);
  return mesh;
}

}  // namespace

void Box::bind(Parameters& parameters) {
  bind_extents(parameters, x, y, z);
  parameters.integer("faces", faces, 12, kMaxFaces,
                     "upper limit for the triangles; sides are divided as finely as it allows");
}

Mesh Box::build() const {
  const Vector3 size(x, y, z);
  const LatticePoint cells = divide_box(size, faces);
  return box_surface(cells, [&](const LatticePoint& p) {
    return Vector3(x * (1.0 * p[0] / cells[0] - 0.5), y * (1.0 * p[1] / cells[1] - 0.5),
                   z * (1.0 * p[2] / cells[2] - 0.5));
  });
}

void Pyramid::bind(Parameters& parameters) {
  bind_length(parameters, "base", base, "side of the square base");
  bind_length(parameters, "height", height, "height of the apex above the base");
}

Mesh Pyramid::build() const {
  Mesh mesh;
  const Ring ground = add_square(mesh, base, 0);
  add_strip(mesh, ground, add_ring(mesh, {{0, 0, height}}));
  add_cap(mesh, ground, Facing::kDown);
  return mesh;
}

void Prism::bind(Parameters& parameters) {
  parameters.integer("sides", sides, 3, 1'000'000, "sides of the regular polygon");
  bind_length(parameters, "radius", radius, "radius of the polygon's corners");
  bind_length(parameters, "height", height, "distance between the two ends");
  parameters.flag("caps", caps, "whether the ends are closed");
}

Mesh Prism::build() const {
  Mesh mesh;
  const Ring bottom = add_circle(mesh, sides, radius, 0);
  const Ring top = add_circle(mesh, sides, radius, height);
  add_strip(mesh, bottom, top);
  if (caps) {
    add_cap(mesh, bottom, Facing::kDown);
    add_cap(mesh, top, Facing::kUp);
  }
  return mesh;
}

void LShape::bind(Parameters& parameters) {
  bind_extents(parameters, x, y, z);
  parameters.real("notch", notch, 0.01, 0.99, "part of the x and y extents that is missing at a corner");
}

Mesh LShape::build() const {
  const double u = x * (1 - notch), v = y * (1 - notch);
  return extrude({{0, 0, 0}, {x, 0, 0}, {x, v, 0}, {u, v, 0}, {u, y, 0}, {0, y, 0}}, z);
}

void Stairs::bind(Parameters& parameters) {
  bind_extents(parameters, x, y, z);
  parameters.integer("steps", steps, 1, 1'000'000, "number of steps, along y and up z");
}

Mesh Stairs::build() const {
  std::vector<Vector3> profile{{0, 0, 0}};
  for (int i = 0; i < steps; ++i) {
    const double run = y * (steps - i) / steps;
    profile.emplace_back(run, z * i / steps, 0);
    profile.emplace_back(run, z * (i + 1) / steps, 0);
  }
  profile.emplace_back(0, z, 0);
  Mesh mesh = extrude(profile, x);
  for (auto& p : mesh.vertices) p = {p.z(), p.x(), p.y()};  // a cyclic change of the coordinates keeps the orientation
  return mesh;
}

void SteppedPyramid::bind(Parameters& parameters) {
  bind_length(parameters, "base", base, "side of the lowest square");
  bind_length(parameters, "height", height, "height of all steps together");
  parameters.integer("steps", steps, 1, 1'000'000, "number of steps; with many it looks like a pyramid");
}

Mesh SteppedPyramid::build() const {
  Mesh mesh;
  std::vector<Ring> rings;
  for (int i = 0; i < steps; ++i) {
    const double side = base * (steps - i) / steps;
    rings.push_back(add_square(mesh, side, height * i / steps));
    rings.push_back(add_square(mesh, side, height * (i + 1) / steps));
  }
  add_strips(mesh, rings);
  add_cap(mesh, rings.front(), Facing::kDown);
  add_cap(mesh, rings.back(), Facing::kUp);
  return mesh;
}

}  // namespace rectilin::shapes
