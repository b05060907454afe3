#include "rectilin/render/camera.h"

#include <algorithm>
#include <cmath>

#include "views/placed.h"

namespace rectilin::render {

Ball ball_around(const Mesh& mesh) {
  const int exponent = size_exponent(mesh);
  Vector3 lower = Vector3::Constant(4), upper = -lower;
  for (const Triangle& t : mesh.triangles)
    for (const auto i : t) {
      const Vector3 p = times_power(mesh.vertices[i], -exponent);
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
  if (mesh.triangles.empty()) return {Vector3::Zero(), 0};
  const Vector3 centre = (lower + upper) / 2;
  double square = 0;
  for (const Triangle& t : mesh.triangles)
    for (const auto i : t) square = std::max(square, (times_power(mesh.vertices[i], -exponent) - centre).squaredNorm());
  // Scaled up by less than two, so that the radius of a mesh as large as numbers go may be infinite: keep it finite.
  const double radius = std::min(std::scalbn(std::sqrt(square), exponent), std::numeric_limits<double>::max());
  return {times_power(centre, exponent), radius};
}

Rotation frame_towards(const Vector3& direction, const Vector3& up) {
  const Vector3 towards = direction.normalized();
  Vector3 right = up.normalized().cross(towards);
  if (right.norm() < 1e-9) {
    int axis;
    up.cwiseAbs().maxCoeff(&axis);
    right = Vector3::Unit((axis + 1) % 3).cross(towards);
  }
  right.normalize();
  Eigen::Matrix3d rows;
  rows.row(0) = right;
  rows.row(1) = towards.cross(right);
  rows.row(2) = towards;
  return Rotation::from_matrix(rows);
}

}  // namespace rectilin::render
