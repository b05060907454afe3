#include "surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rectilin::pose {
namespace {

struct Extent {
  Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 upper = -lower;

  void add(const Vector3& point) {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  // Halves first: the sum or difference of two large numbers may be beyond double's range.
  Vector3 middle() const { return lower / 2 + upper / 2; }
  double half_size() const { return (upper / 2 - lower / 2).maxCoeff(); }
};

Vector3 scaled(const Vector3& v, int exponent) {
  return {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
}

/// Adds up A/12 (aa' + bb' + cc' + 9 gg') over the triangles, the integral of x x' over the surface (g the centroid).
Eigen::Matrix3d second_moments(const Surface& surface) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < surface.areas.size(); ++i) {
    const auto& t = surface.mesh.triangles[i];
    const Vector3 &a = surface.mesh.vertices[t[0]], &b = surface.mesh.vertices[t[1]], &c = surface.mesh.vertices[t[2]];
    const Vector3 g = (a + b + c) / 3;
    sum += surface.areas[i] / 12 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + 9 * g * g.transpose());
  }
  return sum;
}

}  // namespace

Surface make_surface(const Mesh& mesh) {
  Extent extent;
  for (const Triangle& t : mesh.triangles)
    for (const auto corner : t) extent.add(mesh.vertices[corner]);
  const double size = mesh.triangles.empty() ? 0 : extent.half_size();
  if (!(size > 0)) throw MeshError("the total area of its faces is zero");

  Surface surface;
  std::frexp(size, &surface.exponent);
  surface.exponent += 1;  // `size` is half the extent
  const Vector3 middle = scaled(extent.middle(), -surface.exponent);
  std::vector<std::uint32_t> place(mesh.vertices.size(), std::numeric_limits<std::uint32_t>::max());
  const auto corner_of = [&](std::uint32_t i) {
    if (place[i] == std::numeric_limits<std::uint32_t>::max()) {
      place[i] = static_cast<std::uint32_t>(surface.mesh.vertices.size());
      surface.mesh.vertices.push_back(scaled(mesh.vertices[i], -surface.exponent) - middle);
    }
    return place[i];
  };
  Vector3 centre = Vector3::Zero();
  for (const Triangle& given : mesh.triangles) {
    const Triangle t = {corner_of(given[0]), corner_of(given[1]), corner_of(given[2])};
    const Vector3 &a = surface.mesh.vertices[t[0]], &b = surface.mesh.vertices[t[1]], &c = surface.mesh.vertices[t[2]];
    const Vector3 cross = (b - a).cross(c - a);
    const double twice = cross.norm();
    if (!(twice > 0)) continue;
    surface.mesh.triangles.push_back(t);
    surface.areas.push_back(twice / 2);
    surface.normals.push_back(cross / twice);
    surface.area += twice / 2;
    centre += twice / 6 * (a + b + c);
  }
  if (!(surface.area > 0)) throw MeshError("the total area of its faces is zero");

  centre /= surface.area;
  for (Vector3& v : surface.mesh.vertices) {
    v -= centre;
    surface.radius = std::max(surface.radius, v.norm());
  }
  surface.centre = scaled(centre + middle, surface.exponent);
  surface.moments = second_moments(surface) / surface.area;
  surface.rms = std::sqrt(surface.moments.trace());
  return surface;
}

}  // namespace rectilin::pose
