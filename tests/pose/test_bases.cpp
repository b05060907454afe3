// Flat sides of hulls against what can be counted.
#include "bases.h"
#include "pose_support.h"
#include "rectilin/pose/convex_hull.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::test;

TEST_CASE("a box is all flat along its edges, a sphere nowhere", "[pose]") {
  const Rotation turn = rotation_from_euler(0.4, 1.1, 2.3);
  const pose::Bases box(moved(shape("box?x=1&y=2&z=3"), turn));
  for (int k = 0; k < 3; ++k) CHECK(box.share(turn.matrix().col(k)) == Approx(1));
  CHECK(box.share((turn.matrix() * Vector3(1, 1, 1)).normalized()) < 0.01);
  const pose::Bases sphere(pose::convex_hull(shape("sphere?kind=even&faces=20000")));
  CHECK(sphere.share(Vector3(0.6, 0, 0.8)) == Approx(2 * 0.14 * 0.14).epsilon(0.05));
}

TEST_CASE("four feet are a side, whatever is between them", "[pose]") {
  Mesh table = moved(shape("box?x=2&y=1&z=0.1"), Rotation(), 1, {0, 0, 0.6});
  for (const double x : {-0.9, 0.9})
    for (const double y : {-0.4, 0.4})
      table = together(table, moved(shape("box?x=0.2&y=0.2&z=0.6"), Rotation(), 1, {x, y, 0.3}));
  const Rotation turn = rotation_from_euler(1, 0.2, 0.7);
  const pose::Bases bases(pose::convex_hull(moved(table, turn)));
  CHECK(bases.share(turn.matrix().col(2)) == Approx(1).epsilon(1e-9));
  const std::vector<Vector3> sides = bases.flattest(8);
  REQUIRE(sides.size() >= 3);
  CHECK(std::abs(sides.front().dot(turn.matrix().col(2))) == Approx(1));
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(std::abs(sides[i].dot(sides[j])) < std::cos(0.17));
}
