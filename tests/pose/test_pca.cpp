// Principal axes against closed forms and against sums over many pieces.
#include <Eigen/Eigenvalues>
#include <numbers>

#include "pose_support.h"
#include "support/catch.h"
#include "surface.h"

using namespace rectilin;
using namespace rectilin::test;

namespace {

/// Each triangle split in four, again and again: the sum of A g g' over the pieces tends to the integral.
Eigen::Matrix3d moments_by_pieces(const Vector3& a, const Vector3& b, const Vector3& c, int depth) {
  if (depth == 0) {
    const Vector3 g = (a + b + c) / 3;
    return (b - a).cross(c - a).norm() / 2 * g * g.transpose();
  }
  const Vector3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  return moments_by_pieces(a, ab, ca, depth - 1) + moments_by_pieces(ab, b, bc, depth - 1) +
         moments_by_pieces(ca, bc, c, depth - 1) + moments_by_pieces(ab, bc, ca, depth - 1);
}

}  // namespace

TEST_CASE("second moments of a surface are those of ever smaller pieces of it", "[pca]") {
  Random random(4);
  const Mesh mesh = random_mesh(random, 20);
  const pose::Surface surface = pose::make_surface(mesh);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Triangle& t : surface.mesh.triangles)
    sum += moments_by_pieces(surface.mesh.vertices[t[0]], surface.mesh.vertices[t[1]], surface.mesh.vertices[t[2]], 7);
  CHECK((sum / surface.area - surface.moments).norm() < 1e-4 * surface.moments.norm());
}

TEST_CASE("moments of a box in closed form", "[pca]") {
  // A box of edges a, b, c: faces across x are two of area bc at distance a/2, the others spread a^2/12 along x.
  const double a = 1, b = 2, c = 3;
  const pose::Surface surface = pose::make_surface(shape("box?x=1&y=2&z=3"));
  const double area = 2 * (a * b + b * c + c * a);
  const auto along = [&](double p, double q, double r) {
    return (2 * q * r * p * p / 4 + 2 * (p * q + p * r) * p * p / 12) / area;
  };
  const double unit = std::ldexp(1.0, -2 * surface.exponent);
  CHECK(surface.moments(0, 0) == Approx(unit * along(a, b, c)));
  CHECK(surface.moments(1, 1) == Approx(unit * along(b, a, c)));
  CHECK(surface.moments(2, 2) == Approx(unit * along(c, a, b)));
  CHECK(surface.moments.cwiseAbs().sum() - surface.moments.trace() < 1e-15);
}

TEST_CASE("the centre is that of the surface, however it is triangulated", "[pca]") {
  const Mesh box = moved(shape("box?x=1&y=2&z=3"), Rotation(), 1, {5, -7, 11});
  Mesh finer = box;  // one face split at a point far from its middle
  const Triangle t = finer.triangles.front();
  const Vector3 inside = 0.8 * box.vertices[t[0]] + 0.1 * box.vertices[t[1]] + 0.1 * box.vertices[t[2]];
  const auto n = static_cast<std::uint32_t>(finer.vertices.size());
  finer.vertices.push_back(inside);
  finer.triangles.front() = {t[0], t[1], n};
  finer.triangles.push_back({t[1], t[2], n});
  finer.triangles.push_back({t[2], t[0], n});
  const pose::Pose a = pose_of("pca", box), b = pose_of("pca", finer);
  CHECK((a.centre - b.centre).norm() < 1e-13);
  CHECK(frame_angle(a.rotation, b.rotation) < 1e-12);
  CHECK(a.scale == Approx(2 / std::sqrt(14.0)));  // the half diagonal becomes one
  const pose::Pose by_vertices = pose_of("vertex-pca", finer);
  CHECK(frame_angle(by_vertices.rotation, Rotation()) > 1e-3);  // which do depend on it
}

TEST_CASE("principal axes say what equal moments leave open", "[pca]") {
  CHECK(pose_of("pca", shape("box?x=1&y=2&z=3")).uniqueness == pose::Uniqueness::kUnique);
  CHECK(pose_of("pca", shape("box")).uniqueness == pose::Uniqueness::kNone);
  const pose::Pose square = pose_of("pca", moved(shape("box?x=1&y=1&z=3"), rotation_from_euler(0.3, 0.5, 0.7)));
  CHECK(square.uniqueness == pose::Uniqueness::kContinuum);
  REQUIRE(square.free_axis >= 0);
  const Vector3 long_axis = rotation_from_euler(0.3, 0.5, 0.7).matrix().col(2);
  CHECK(std::abs(square.rotation.axis(square.free_axis).dot(long_axis)) > 1 - 1e-12);
}

TEST_CASE("normal PCA of a box is the box", "[pca]") {
  const Rotation turn = rotation_from_euler(1, 0.4, 2);
  const pose::Pose found = pose_of("normal-pca", moved(shape("box?x=1&y=2&z=3"), turn));
  CHECK(frame_angle(found.rotation, turn.inverse()) < 1e-12);
}
