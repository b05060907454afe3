// Triangles that subdivide the sphere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

namespace rectilin::certification {

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

/// A number that g . u - u . F u does not fall below on the triangle, F symmetric, or minus infinity: its least
/// coefficient in the coordinates a of u = sum a_i p_i, unless the sphere bulges too far from the corners' plane for
/// that (papers/certificate.md, lemma 3). Edges must not be longer than half a radian.
inline double least_on(const Triangle3& p, const Eigen::Vector3d& g, const Eigen::Matrix3d& form) {
  const Eigen::Vector3d linear(g.dot(p[0]), g.dot(p[1]), g.dot(p[2]));
  double least = std::numeric_limits<double>::infinity(), most_form = 0;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d image = form * p[i];
    for (int j = 0; j <= i; ++j) {
      const double product = image.dot(p[j]);
      most_form = std::max(most_form, product);
      least = std::min(least, 0.5 * (linear[i] + linear[j]) - product);
    }
  }
  return linear.minCoeff() >= 2.2 * most_form ? least : -std::numeric_limits<double>::infinity();
}

}  // namespace rectilin::certification
