#include <cmath>
#include <numbers>

#include "rectilin/base/rotation.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

constexpr double kPi = std::numbers::pi;

bool is_rotation(const Eigen::Matrix3d& m) {
  return (m * m.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-14 && std::abs(m.determinant() - 1) < 1e-14;
}

/// A turn of the coordinate frame about one coordinate axis.
Eigen::Matrix3d frame_turn(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(-angle, axis).toRotationMatrix();
}

}  // namespace

TEST_CASE("Euler angles turn the frame about x, then y, then z (eqs. 35-37)", "[rotation]") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double a = random.uniform(-7, 7), b = random.uniform(-7, 7), c = random.uniform(-7, 7);
    const Eigen::Matrix3d successive = frame_turn(c, Eigen::Vector3d::UnitZ()) *
                                       frame_turn(b, Eigen::Vector3d::UnitY()) *
                                       frame_turn(a, Eigen::Vector3d::UnitX());
    const Rotation r = rotation_from_euler(a, b, c);
    REQUIRE(is_rotation(r.matrix()));
    REQUIRE((r.matrix() - successive).cwiseAbs().maxCoeff() < 1e-14);
  }
}

TEST_CASE("Euler angles: entries as printed in eqs. (35)-(37)", "[rotation]") {
  const double a = 0.3, b = 0.5, c = 1.1;
  const Eigen::Matrix3d m = rotation_from_euler(a, b, c).matrix();
  REQUIRE(m(2, 0) == std::sin(b));
  REQUIRE(m(2, 1) == -std::cos(b) * std::sin(a));
  REQUIRE(m(2, 2) == std::cos(b) * std::cos(a));
  REQUIRE(m(0, 0) == std::cos(c) * std::cos(b));
  REQUIRE(m(1, 0) == -std::sin(c) * std::cos(b));
  REQUIRE(m(0, 2) == Approx(std::sin(c) * std::sin(a) - std::cos(c) * std::sin(b) * std::cos(a)).epsilon(1e-15));
  REQUIRE(m(1, 1) == Approx(std::cos(c) * std::cos(a) - std::sin(c) * std::sin(b) * std::sin(a)).epsilon(1e-15));
}

TEST_CASE("Euler angles are recovered, at the poles too", "[rotation]") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Rotation r = random_rotation(random);
    const Eigen::Vector3d e = euler_from_rotation(r);
    REQUIRE((rotation_from_euler(e[0], e[1], e[2]).matrix() - r.matrix()).norm() < 1e-13);
  }
  for (const double beta : {kPi / 2, -kPi / 2}) {
    const Rotation r = rotation_from_euler(0.4, beta, 0.9);
    const Eigen::Vector3d e = euler_from_rotation(r);
    REQUIRE((rotation_from_euler(e[0], e[1], e[2]).matrix() - r.matrix()).norm() < 1e-13);
  }
}

TEST_CASE("Rodrigues vectors and rotation vectors agree with angle and axis", "[rotation]") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    const double angle = random.uniform(1e-9, 3);
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    REQUIRE((rotation_from_rodrigues(std::tan(angle / 2) * axis).matrix() - expected).norm() < 1e-14);
    REQUIRE((rotation_from_vector(angle * axis).matrix() - expected).norm() < 1e-14);
    REQUIRE(angle_between(Rotation(), Rotation::from_matrix(expected)) == Approx(angle).epsilon(1e-12));
  }
  REQUIRE(rotation_from_vector(Eigen::Vector3d::Zero()).matrix() == Eigen::Matrix3d::Identity());
}

TEST_CASE("random rotations are uniform: mean zero, rows isotropic", "[rotation]") {
  Random random(4);
  const int n = 100000;
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  double mean_square = 0;
  for (int i = 0; i < n; ++i) {
    const Eigen::Matrix3d m = random_rotation(random).matrix();
    mean += m / n;
    mean_square += m(1, 2) * m(1, 2) / n;
  }
  // Standard deviations: 1/sqrt(3n) = 0.0018 an entry; of a square 0.3/sqrt(n) = 0.001.
  REQUIRE(mean.cwiseAbs().maxCoeff() < 0.01);
  REQUIRE(mean_square == Approx(1.0 / 3).margin(0.005));
}

TEST_CASE("the frame's symmetries are a group of 24 proper rotations", "[rotation]") {
  const auto group = frame_symmetries();
  REQUIRE(group.size() == 24);
  for (const Rotation& a : group) {
    REQUIRE(a.matrix().determinant() == 1.0);
    for (const Rotation& b : group) {
      int found = 0;
      for (const Rotation& c : group) found += c.matrix() == (a * b).matrix();
      REQUIRE(found == 1);
    }
  }
}

TEST_CASE("reduction gives one representative in the cubic fundamental zone", "[rotation]") {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Rotation r = random_rotation(random), reduced = reduce_to_zone(r);
    const Eigen::Quaterniond q = reduced.quaternion();
    const Eigen::Vector3d rho = q.vec() / q.w();
    REQUIRE(rho.cwiseAbs().maxCoeff() <= std::sqrt(2.0) - 1 + 1e-12);
    REQUIRE(rho.cwiseAbs().sum() <= 1 + 1e-12);
    const Rotation& d = frame_symmetries()[random.below(24)];
    REQUIRE((reduce_to_zone(d * r).matrix() - reduced.matrix()).norm() < 1e-12);
    REQUIRE(frame_angle(r, d * r) < 1e-14);
    const Rotation other = random_rotation(random);
    double least = 4;
    for (const Rotation& symmetry : frame_symmetries()) least = std::min(least, angle_between(r, symmetry * other));
    REQUIRE(frame_angle(r, other) == Approx(least).epsilon(1e-12));
  }
  REQUIRE(frame_angle(Rotation(), rotation_from_vector({0, 0, 0.2})) == Approx(0.2));
}
