#include "rectilin/base/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace rectilin {
namespace {

std::array<Rotation, 24> make_frame_symmetries() {
  std::array<Rotation, 24> group;
  constexpr int permutations[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  std::size_t count = 0;
  for (const auto& p : permutations)
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (int k = 0; k < 3; ++k) m(k, p[k]) = (signs >> k) & 1 ? -1.0 : 1.0;
      if (m.determinant() > 0) group[count++] = Rotation::from_matrix(m);
    }
  return group;
}

}  // namespace

Rotation rotation_from_euler(double alpha, double beta, double gamma) {
  const double ca = std::cos(alpha), sa = std::sin(alpha);
  const double cb = std::cos(beta), sb = std::sin(beta);
  const double cg = std::cos(gamma), sg = std::sin(gamma);
  Eigen::Matrix3d m;
  m << cg * cb, sg * ca + cg * sb * sa, sg * sa - cg * sb * ca,  // eq. (35)
      -sg * cb, cg * ca - sg * sb * sa, cg * sa + sg * sb * ca,  // eq. (36)
      sb, -cb * sa, cb * ca;                                     // eq. (37)
  return Rotation::from_matrix(m);
}

Eigen::Vector3d euler_from_rotation(const Rotation& rotation) {
  const Eigen::Matrix3d& m = rotation.matrix();
  const double cos_beta = std::hypot(m(0, 0), m(1, 0));
  const double beta = std::atan2(m(2, 0), cos_beta);
  // Near beta = +-pi/2 the first column has no digits left that tell gamma from alpha: gamma is set to 0, and alpha
  // takes the whole turn.
  if (cos_beta < 1e-12) return {std::atan2(m(1, 2), m(1, 1)), beta, 0.0};
  return {std::atan2(-m(2, 1), m(2, 2)), beta, std::atan2(-m(1, 0), m(0, 0))};
}

Rotation rotation_from_rodrigues(const Eigen::Vector3d& rho) {
  return Rotation::from_quaternion({1.0, rho.x(), rho.y(), rho.z()});
}

Rotation rotation_from_vector(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  // sin(angle/2)/angle, without dividing by zero: below 1e-4 two terms of the series are exact to rounding.
  const double s = angle > 1e-4 ? std::sin(angle / 2) / angle : 0.5 - angle * angle / 48;
  return Rotation::from_quaternion({std::cos(angle / 2), s * turn.x(), s * turn.y(), s * turn.z()});
}

Rotation frame_about(const Eigen::Vector3d& axis) {
  Eigen::Matrix3d rows;
  rows.row(0) = axis.unitOrthogonal().transpose();
  rows.row(2) = axis.transpose();
  rows.row(1) = axis.cross(Eigen::Vector3d(rows.row(0).transpose())).transpose();
  return Rotation::from_matrix(rows);
}

Rotation random_rotation(Random& random) {
  const double u = random.uniform();
  const double a = 2 * std::numbers::pi * random.uniform();
  const double b = 2 * std::numbers::pi * random.uniform();
  const double r = std::sqrt(1 - u), s = std::sqrt(u);
  return Rotation::from_quaternion({s * std::cos(b), r * std::sin(a), r * std::cos(a), s * std::sin(b)});
}

double angle_between(const Rotation& a, const Rotation& b) {
  const Eigen::Quaterniond q = (b * a.inverse()).quaternion();
  return 2 * std::atan2(q.vec().norm(), std::abs(q.w()));
}

std::span<const Rotation> frame_symmetries() {
  static const std::array<Rotation, 24> group = make_frame_symmetries();
  return group;
}

Rotation reduce_to_zone(const Rotation& rotation) {
  // The angle falls as the trace grows.
  Rotation best = rotation;
  for (const Rotation& d : frame_symmetries()) {
    const Rotation candidate = d * rotation;
    if (candidate.matrix().trace() > best.matrix().trace()) best = candidate;
  }
  return best;
}

double frame_angle(const Rotation& a, const Rotation& b) {
  // The 24 symmetries are the quaternions (1,0,0,0), (1,1,0,0)/sqrt(2) and (1,1,1,1)/2 with all permutations and signs,
  // so the largest real part of a product with them comes from the sizes of the components, sorted.
  std::array<double, 4> q;
  Eigen::Map<Eigen::Vector4d>(q.data()) = (b * a.inverse()).quaternion().coeffs().cwiseAbs();
  std::sort(q.begin(), q.end(), std::greater());
  const auto [w, x, y, z] = q;
  const Eigen::Vector4d best[3] = {{w, x, y, z},
                                   Eigen::Vector4d(w + x, w - x, y + z, y - z) * std::numbers::sqrt2 / 2,
                                   Eigen::Vector4d(w + x + y + z, w + x - y - z, w - x + y - z, w - x - y + z) / 2};
  const auto& closest =
      *std::max_element(std::begin(best), std::end(best), [](const auto& p, const auto& r) { return p[0] < r[0]; });
  return 2 * std::atan2(closest.tail<3>().norm(), closest[0]);
}

}  // namespace rectilin
