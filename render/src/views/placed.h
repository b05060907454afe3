// Coordinates of any size brought near 1 without overflow.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rectilin/render/camera.h"

namespace rectilin::render {

inline Vector3 times_power(const Vector3& v, int exponent) {
  return {std::scalbn(v.x(), exponent), std::scalbn(v.y(), exponent), std::scalbn(v.z(), exponent)};
}

/// e such that every coordinate that a triangle uses is below 2^e in size, and one is at least 2^(e-1); 0 if all are 0.
inline int size_exponent(const Mesh& mesh) {
  double size = 0;
  for (const Triangle& t : mesh.triangles)
    for (const auto i : t) size = std::max(size, mesh.vertices[i].lpNorm<Eigen::Infinity>());
  return size > 0 ? std::ilogb(size) + 1 : 0;
}

/// Takes points to the unit ball. A ball without extent counts as one of radius 1.
class ToUnitBall {
 public:
  explicit ToUnitBall(const Ball& ball) : half_centre_(times_power(ball.centre, -1)) {
    if (!(ball.radius >= 0) || !std::isfinite(ball.radius) || !ball.centre.allFinite())
      throw std::invalid_argument("a picture shows a ball with a finite centre and radius");
    exponent_ = ball.radius > 0 ? std::ilogb(ball.radius) : 0;
    radius_ = ball.radius > 0 ? std::scalbn(ball.radius, -exponent_) : 1;
  }
  /// Halves first, so that no difference overflows. std::invalid_argument beyond `reach` radii.
  Vector3 operator()(const Vector3& point, double reach) const {
    const Vector3 p = times_power(times_power(point, -1) - half_centre_, 1 - exponent_) / radius_;
    if (!(p.lpNorm<Eigen::Infinity>() <= reach))
      throw std::invalid_argument("the mesh reaches too far out of the picture");
    return p;
  }

 private:
  Vector3 half_centre_;
  int exponent_;
  double radius_;
};

}  // namespace rectilin::render
