#include "frames.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace rectilin::pose {

Rotation frame_of(Eigen::Matrix3d rows) {
  if (rows.determinant() < 0) rows.row(2) = -rows.row(2);
  return Rotation::from_matrix(rows);
}

Eigen::Vector3d hemisphere_point(int i, int count) {
  const double z = 1 - (i + 0.5) / count, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

double line_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

}  // namespace rectilin::pose
