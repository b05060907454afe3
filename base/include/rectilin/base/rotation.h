// Rotations of the coordinate frame: the search space of everything here.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>

#include "rectilin/base/random.h"

namespace rectilin {

/// A proper rotation R. Its rows are the axes of the rotated frame: R v holds the coordinates of v in that frame, and
/// P(R) = h(row 1) + h(row 2) + h(row 3).
class Rotation {
 public:
  Rotation() : matrix_(Eigen::Matrix3d::Identity()) {}

  /// `m` must be orthonormal with determinant +1, up to rounding; this is not checked.
  static Rotation from_matrix(const Eigen::Matrix3d& m) { return Rotation(m); }

  /// q may have any length but zero.
  static Rotation from_quaternion(const Eigen::Quaterniond& q) { return Rotation(q.normalized().toRotationMatrix()); }

  const Eigen::Matrix3d& matrix() const { return matrix_; }

  /// Row k, k in {0, 1, 2}: a unit vector in the mesh's coordinates.
  Eigen::Vector3d axis(int k) const { return matrix_.row(k).transpose(); }

  Eigen::Quaterniond quaternion() const { return Eigen::Quaterniond(matrix_); }

  Rotation operator*(const Rotation& other) const { return Rotation(matrix_ * other.matrix_); }
  Rotation inverse() const { return Rotation(matrix_.transpose()); }

 private:
  explicit Rotation(const Eigen::Matrix3d& m) : matrix_(m) {}
  Eigen::Matrix3d matrix_;
};

/// The paper's R(alpha, beta, gamma), eqs. (35)-(37): turns about x, then y, then z, in radians. The third row depends
/// on alpha and beta alone, bit for bit, so rotations that differ in gamma alone can share work.
Rotation rotation_from_euler(double alpha, double beta, double gamma);

/// The angles of eqs. (35)-(37) that give this rotation: alpha and gamma in (-pi, pi], beta in [-pi/2, pi/2]. At beta =
/// +-pi/2, where only alpha +- gamma is determined, gamma is 0.
Eigen::Vector3d euler_from_rotation(const Rotation& rotation);

/// The rotation with Rodrigues vector rho = tan(angle / 2) * axis.
Rotation rotation_from_rodrigues(const Eigen::Vector3d& rho);

/// The rotation about the direction of `turn` by its length, in radians.
Rotation rotation_from_vector(const Eigen::Vector3d& turn);

/// Some frame whose third axis is `axis`, a unit vector.
Rotation frame_about(const Eigen::Vector3d& axis);

/// A random rotation, uniform with respect to the invariant (Haar) measure (Shoemake 1992).
Rotation random_rotation(Random& random);

/// The angle, in [0, pi], of the rotation that takes a to b.
double angle_between(const Rotation& a, const Rotation& b);

/// The 24 proper rotations D that map the coordinate axes onto themselves. D R has the same three axes as R, in another
/// order and with other signs, so an objective of the frame has the same value at both.
std::span<const Rotation> frame_symmetries();

/// The one of the 24 rotations D R, D in frame_symmetries(), with the smallest angle. It lies in the cubic fundamental
/// zone, |rho_i| <= sqrt(2)-1 and |rho_1|+|rho_2|+|rho_3| <= 1 in its Rodrigues vector, which holds one representative
/// of each frame.
Rotation reduce_to_zone(const Rotation& rotation);

/// Angle between two frames: the smallest angle_between(a, D b) over D in frame_symmetries().
double frame_angle(const Rotation& a, const Rotation& b);

}  // namespace rectilin
