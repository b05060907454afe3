// Turning one shape to lie like another.
#include <Eigen/LU>

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/same_pose.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

Mesh turned(Mesh mesh, const Eigen::Matrix3d& matrix) {
  for (Vector3& p : mesh.vertices) p = matrix * p;
  return mesh;
}

void check_rotation(const Eigen::Matrix3d& m) {
  CHECK((m * m.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
  CHECK(m.determinant() > 0);
}

}  // namespace

TEST_CASE("A turned and scaled copy is turned back", "[search]") {
  // Stretched, or the treads would be as long as the steps are high and half a turn would change nothing.
  const Mesh stairs = turned(load_mesh("shape:stairs?steps=4").mesh, Vector3(1, 1.4, 0.8).asDiagonal());
  for (int k = 0; k < 4; ++k) {
    const Eigen::Matrix3d turn = rotation_from_vector({0.7 * k, 1.1 - k, 0.3 + 0.5 * k}).matrix();
    const auto pose = search::same_pose(stairs, turned(stairs, 3 * turn));
    check_rotation(pose.rotation);
    // Stairs have no symmetry but a mirror image's, so the way back is the only one.
    CHECK((pose.rotation * turn - Eigen::Matrix3d::Identity()).norm() < 0.05);
    CHECK(pose.distance < 0.03);
  }
}

TEST_CASE("Shapes that are merely alike are turned by a whole number of right angles in their frames", "[search]") {
  const Mesh box = load_mesh("shape:box?x=2&y=1.5").mesh, longer = load_mesh("shape:box?x=1&y=3&z=1.2").mesh;
  const auto pose = search::same_pose(box, longer);
  check_rotation(pose.rotation);
  CHECK(pose.distance > 0.05);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double x = std::abs(pose.rotation(i, j));
      CHECK(std::min(x, std::abs(x - 1)) < 1e-3);
    }
  CHECK(std::abs(pose.rotation(0, 1)) > 0.99);  // the longest side lies like the longest
}
