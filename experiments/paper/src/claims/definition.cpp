#include "claims/definition.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rectilin::paper::claims {
namespace {

using LongVector = Eigen::Matrix<long double, 3, 1>;
using LongMatrix = Eigen::Matrix<long double, 3, 3>;

constexpr int kRotations = 3;

Vector3 random_angles(Random& random) {
  return 2 * std::numbers::pi * Vector3(random.uniform(), random.uniform(), random.uniform());
}

/// Calls face(eta') for every triangle, eta' as in eq. (5). In extended precision where the
/// platform has it, so that a mesh far from the origin loses nothing in turning.
template <class Face>
void for_each_turned_face(const Mesh& mesh, const Eigen::Matrix3d& rotation, Face face) {
  const LongMatrix r = rotation.cast<long double>();
  for (const Triangle& t : mesh.triangles) {
    LongVector x[3];
    for (int j = 0; j < 3; ++j) x[j] = r * mesh.vertices[t[j]].cast<long double>();  // eq. (3)
    face(LongVector((x[1] - x[0]).cross(x[2] - x[0])));
  }
}

}  // namespace

Rotation frame_turned(double alpha, double beta, double gamma) {
  // Turning a frame by an angle turns coordinates by its negative.
  const auto turned = [](double angle, int axis) {
    return Eigen::AngleAxisd(-angle, Vector3::Unit(axis)).toRotationMatrix();
  };
  return Rotation::from_matrix(turned(gamma, 2) * turned(beta, 1) * turned(alpha, 0));
}

Finding check_convention(Random random, EulerConvention convention) {
  Finding finding;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 a = random_angles(random);
    const Rotation expected = frame_turned(a[0], a[1], a[2]);
    const Rotation got = convention(a[0], a[1], a[2]);
    const double margin = -(got.matrix() - expected.matrix()).cwiseAbs().maxCoeff();
    if (margin < finding.margin) finding = {margin, "three turns of the frame", nullptr, expected, {}};
  }
  return finding;
}

Finding check_definition(const TestMesh& tested, Random random, EulerConvention convention) {
  const double rounding = coordinate_rounding(*tested.mesh, tested.vectors().area());
  Finding finding{.where = tested.source};
  for (int i = 0; i < kRotations; ++i) {
    const Vector3 a = random_angles(random);
    long double area = 0, projected = 0;  // S and P, eqs. (10), (11)
    for_each_turned_face(*tested.mesh, frame_turned(a[0], a[1], a[2]).matrix(), [&](const LongVector& eta) {
      area += eta.norm() / 2;            // eq. (6)
      projected += eta.lpNorm<1>() / 2;  // eq. (7)
    });
    const Rotation rotation = convention(a[0], a[1], a[2]);
    const double expected = static_cast<double>(projected / area);
    const double margin = rounding - std::abs(tested.objective->value(rotation) - expected);
    if (margin < finding.margin) finding.margin = margin, finding.rotation = rotation;
  }
  finding.margin = std::min(finding.margin, 0.0);  // an allowance for rounding is no margin
  return finding;
}

Finding check_angles(const TestMesh& tested, Random random) {
  const AreaVectors& vectors = tested.vectors();
  Finding finding{.where = tested.source};
  for (int i = 0; i < kRotations; ++i) {
    const Rotation rotation = random_rotation(random);
    double projected = 0;
    for (std::size_t k = 0; k < vectors.size(); ++k) {
      const Vector3 v = rotation.matrix() * vectors[k];
      const double psi = std::atan2(std::hypot(v.x(), v.y()), v.z()), phi = std::atan2(v.y(), v.x());
      projected += v.norm() * (std::abs(std::cos(psi)) + std::abs(std::sin(psi) * std::cos(phi)) +
                               std::abs(std::sin(psi) * std::sin(phi)));
    }
    const double margin = -std::abs(tested.objective->value(rotation) - projected / vectors.total);
    if (margin < finding.margin) finding.margin = margin, finding.rotation = rotation;
  }
  return finding;
}

}  // namespace rectilin::paper::claims
