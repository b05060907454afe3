// Triangles that subdivide the sphere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

namespace rectilin::bounding {

/// Corners of a spherical triangle, unit vectors. Its points are the unit vectors sum a_i p_i with a_i >= 0.
using Triangle3 = std::array<Eigen::Vector3d, 3>;

inline Eigen::Vector3d centre_of(const Triangle3& p) { return (p[0] + p[1] + p[2]).normalized(); }

/// Four triangles round the midpoints of the edges. A midpoint has the same bits seen from either side, so no rounding
/// opens a gap between neighbours.
inline std::array<Triangle3, 4> quarters(const Triangle3& p) {
  const Eigen::Vector3d a = (p[1] + p[2]).normalized(), b = (p[2] + p[0]).normalized(), c = (p[0] + p[1]).normalized();
  return {Triangle3{a, b, c}, Triangle3{p[0], c, b}, Triangle3{c, p[1], a}, Triangle3{b, a, p[2]}};
}

/// A quarter of the sphere each: with their mirror images, all of it.
inline std::array<Triangle3, 4> upper_octants() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  return {Triangle3{x, y, z}, {y, -x, z}, {-x, -y, z}, {-y, x, z}};
}

/// The minimum of a . u over the triangle if that is not negative, or else something below any: at a point
/// u = sum a_i p_i of unit length the a_i add up to at least 1.
inline double least_linear(const Eigen::Vector3d& a, const Triangle3& p) {
  const double least = std::min({a.dot(p[0]), a.dot(p[1]), a.dot(p[2])});
  return least >= 0 ? least : -a.norm();
}

}  // namespace rectilin::bounding
