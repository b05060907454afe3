#include "samples.h"

#include <cmath>
#include <numbers>

namespace rectilin::pose {
namespace {

double fraction(double x) { return x - std::floor(x); }

}  // namespace

Samples sample_surface(const Surface& surface, std::size_t count) {
  constexpr double kPlastic = 1.32471795724474602596;  // the root of x^3 = x + 1
  // Shares end at multiples of 1/count, and so may triangles: a point well inside a share stays in its triangle however
  // sums are rounded.
  constexpr double kInside = 0.3819660112501051;
  Samples samples;
  samples.points.reserve(count);
  samples.normals.reserve(count);
  const double share = surface.area / static_cast<double>(count);
  samples.patch = std::sqrt(share / std::numbers::pi);
  std::size_t face = 0;
  double before = 0;  // area of the faces before `face`
  for (std::size_t k = 0; k < count; ++k) {
    const double at = (static_cast<double>(k) + kInside) * share;
    while (face + 1 < surface.areas.size() && before + surface.areas[face] <= at) before += surface.areas[face++];
    double s = fraction(static_cast<double>(k + 1) / kPlastic);
    double t = fraction(static_cast<double>(k + 1) / (kPlastic * kPlastic));
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const auto& corner = surface.mesh.triangles[face];
    const Vector3 &a = surface.mesh.vertices[corner[0]], &b = surface.mesh.vertices[corner[1]],
                  &c = surface.mesh.vertices[corner[2]];
    samples.points.push_back(a + s * (b - a) + t * (c - a));
    samples.normals.push_back(surface.normals[face]);
  }
  return samples;
}

}  // namespace rectilin::pose
