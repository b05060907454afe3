// Planes of mirror symmetry.
#include <numbers>

#include "mirror.h"
#include "pose_support.h"
#include "rectilin/pose/convex_hull.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::test;

namespace {

struct Search {
  pose::Surface surface;
  pose::MirrorDefect defect;

  explicit Search(const Mesh& mesh)
      : surface(pose::make_surface(mesh)), defect(surface, pose::convex_hull(surface.mesh)) {}
  std::vector<pose::MirrorPlane> planes(std::size_t count) const { return pose::mirror_planes(defect, count); }
};

double degrees(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * (180 / std::numbers::pi);
}

}  // namespace

TEST_CASE("the mirror planes of a box are its three, exactly", "[mirror]") {
  const Rotation turn = rotation_from_euler(0.4, 0.7, 1.9);
  const Search search(moved(shape("box?x=1&y=2&z=3"), turn));
  const auto planes = search.planes(6);
  REQUIRE(planes.size() >= 3);
  for (int k = 0; k < 3; ++k) {
    CHECK(planes[static_cast<std::size_t>(k)].defect < 0.02);
    double nearest = 90;
    for (int j = 0; j < 3; ++j)
      nearest = std::min(nearest, degrees(planes[static_cast<std::size_t>(k)].normal, turn.matrix().col(j)));
    CHECK(nearest < 1e-6);
  }
  if (planes.size() > 3) CHECK(planes[3].defect > 0.2);
}

TEST_CASE("a square prism has five mirror planes, a bracket one", "[mirror]") {
  const auto prism = Search(shape("box?x=1&y=1&z=3")).planes(8);
  REQUIRE(prism.size() >= 5);
  for (int k = 0; k < 5; ++k) CHECK(prism[static_cast<std::size_t>(k)].defect < 0.02);
  if (prism.size() > 5) CHECK(prism[5].defect > 0.1);

  const auto planes = Search(bracket()).planes(8);
  REQUIRE(planes.size() >= 2);
  CHECK(planes[0].defect < 0.02);
  CHECK(degrees(planes[0].normal, Vector3::UnitZ()) < 1e-6);
  CHECK(planes[1].defect > planes[0].defect + 0.1);
}

TEST_CASE("a mirror plane need not pass through the centre of mass of what is whole", "[mirror]") {
  // Two like boxes and a third that is missing on one side: most of the mesh has the plane x = 0 all the same.
  const Mesh pair = together(moved(shape("box?x=1&y=2&z=0.5"), Rotation(), 1, {-2, 0, 0}),
                             moved(shape("box?x=1&y=2&z=0.5"), Rotation(), 1, {2, 0, 0}));
  const Mesh mesh = together(pair, moved(shape("box?x=0.3&y=0.3&z=0.3"), Rotation(), 1, {1, 0, 1}));
  const auto planes = Search(mesh).planes(4);
  double nearest = 90;
  for (const auto& plane : planes)
    if (plane.defect < 0.2) nearest = std::min(nearest, degrees(plane.normal, Vector3::UnitX()));
  CHECK(nearest < 0.5);
}

TEST_CASE("a defect lies between nothing and all, and random soups have no plane", "[mirror]") {
  Random random(8);
  const Search search(random_mesh(random, 60));
  for (int i = 0; i < 50; ++i) {
    const double defect = search.defect.of(random_vector(random).normalized(), 0.1 * random.normal());
    CHECK(defect >= 0);
    CHECK(defect <= 1);
  }
  CHECK(search.planes(3).front().defect > 0.2);
}
