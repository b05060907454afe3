// Orders and directions of axes.
#include "pose_support.h"
#include "rectilin/pose/axes.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::test;
using pose::AxisRule;

namespace {

/// An L with a lump on one end: no plane of symmetry at all.
Mesh handed() { return together(bracket(), moved(shape("box?x=0.3&y=0.3&z=0.3"), Rotation(), 1, {-1.2, 0.3, 0.4})); }

}  // namespace

TEST_CASE("definite axes are the same for copies in any position", "[axes]") {
  const Mesh mesh = handed();
  const pose::Axes first = pose::resolve_axes(mesh, Rotation(), AxisRule::kDefinite);
  CHECK(first.resolved);
  Random random(9);
  for (int i = 0; i < 20; ++i) {
    const Rotation turn = random_rotation(random);
    const Mesh copy = moved(mesh, turn, random.uniform(0.1, 10), random_vector(random));
    for (const Rotation& symmetry : frame_symmetries()) {
      const pose::Axes axes = pose::resolve_axes(copy, symmetry * turn.inverse(), AxisRule::kDefinite);
      CHECK(axes.resolved);
      CHECK(angle_between(axes.rotation * turn, first.rotation) < 1e-9);
    }
  }
}

TEST_CASE("x is the longest axis and points to the larger half of the area", "[axes]") {
  // A long bar along y with a plate at its far end.
  const Mesh mesh =
      together(shape("box?x=0.2&y=6&z=0.3"), moved(shape("box?x=0.8&y=0.2&z=1.4"), Rotation(), 1, {0, -3, 0}));
  const pose::Axes axes = pose::resolve_axes(mesh, Rotation(), AxisRule::kDefinite);
  CHECK(axes.rotation.axis(0).dot(-Vector3::UnitY()) == Approx(1));
  CHECK_FALSE(axes.resolved);  // the mesh is its own mirror image across x and z: halves are equal
  CHECK(axes.rotation.matrix().determinant() == Approx(1));
  const pose::Axes ordered = pose::resolve_axes(mesh, Rotation(), AxisRule::kOrdered);
  CHECK(std::abs(ordered.rotation.axis(0).y()) == Approx(1));
  CHECK(std::abs(ordered.rotation.axis(1).z()) == Approx(1));
  CHECK(ordered.resolved);
}

TEST_CASE("free axes are the nearest to the given ones", "[axes]") {
  const Mesh mesh = handed();
  for (const Rotation& symmetry : frame_symmetries()) {
    const Rotation small = rotation_from_euler(0.1, -0.2, 0.15);
    CHECK(angle_between(pose::resolve_axes(mesh, symmetry * small, AxisRule::kFree).rotation, small) < 1e-12);
  }
}

TEST_CASE("equal moments are not resolved", "[axes]") {
  CHECK_FALSE(pose::resolve_axes(shape("box"), Rotation(), AxisRule::kOrdered).resolved);
}
