#include "rectilin/paper/closed_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "rectilin/mesh/shapes.h"

namespace rectilin::paper {
namespace {

using std::numbers::pi;

double from_areas(double surface, double projected) { return 3 * surface / projected - 2; }

/// The least of sum_j |cos(phi_j - t)| + |sin(phi_j - t)| over t, for n directions phi_j = 2 pi j /
/// n.
double least_width_sum(int n) {
  if (n % 4 == 0) return 4 / std::tan(pi / n);
  if (n % 2 == 0) return 2 / std::tan(pi / (2.0 * n));
  return 1 / std::tan(pi / (4.0 * n));
}

}  // namespace

double pyramid_rectilinearity(double base, double height) {
  const double slant = std::hypot(height, base / 2);
  return from_areas(base * base + 2 * base * slant, 2 * base * base + 2 * base * height);
}

double prism_rectilinearity(int sides, double radius, double height, bool caps) {
  const double wall = 2 * radius * std::sin(pi / sides) * height;
  const double ends = caps ? sides * radius * radius * std::sin(2 * pi / sides) : 0;
  return from_areas(sides * wall + ends, wall * least_width_sum(sides) + ends);
}

double cylinder_rectilinearity(double radius, double height, bool caps) {
  const double ends = caps ? 2 * pi * radius * radius : 0;
  return from_areas(2 * pi * radius * height + ends, 8 * radius * height + ends);
}

double ellipsoid_area(double a, double b, double c) {
  std::array<double, 3> axes{a, b, c};
  std::ranges::sort(axes, std::ranges::greater());
  const auto [x, y, z] = axes;
  if (x == z) return 4 * pi * x * x;
  const double sine = std::sqrt(1 - z / x * (z / x)), phi = std::asin(sine);
  // The modulus; 1 for y = x up to rounding, where it must not exceed 1.
  const double k = std::min(1.0, std::sqrt(std::max(0.0, 1 - z / y * (z / y))) / sine);
  return 2 * pi * z * z +
         2 * pi * x * y / sine * (std::ellint_2(k, phi) * sine * sine + std::ellint_1(k, phi) * (1 - sine * sine));
}

double ellipsoid_rectilinearity(double a, double b, double c) {
  return from_areas(ellipsoid_area(a, b, c), 2 * pi * (a * b + b * c + c * a));
}

Mesh tilted_top_cube(double tilt) {
  Mesh mesh = make_shape(Spec::parse("box"));
  for (Triangle& t : mesh.triangles) {
    const auto is_top = [&](std::uint32_t v) { return mesh.vertices[v].z() > 0; };
    if (!std::ranges::all_of(t, is_top)) continue;
    for (std::uint32_t& corner : t) {
      const Vector3 p = mesh.vertices[corner];
      corner = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.emplace_back(p.x(), p.y() * std::cos(tilt), p.z() + p.y() * std::sin(tilt));
    }
  }
  return mesh;
}

double tilted_top_rectilinearity(double tilt) { return from_areas(6, 5 + std::cos(tilt) + std::sin(tilt)); }

}  // namespace rectilin::paper
