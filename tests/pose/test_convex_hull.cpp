// Convex hulls: closed, convex, around everything; and the silhouette of a convex body.
#include <map>

#include "pose_support.h"
#include "rectilin/measure/naive_area.h"
#include "rectilin/pose/convex_hull.h"
#include "rectilin/render/silhouette_area.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::test;
using pose::convex_hull;

namespace {

/// Sum over the faces of their area vectors, of the volume, and how far outside a face the furthest point lies.
struct Facts {
  Vector3 flow = Vector3::Zero();
  double volume = 0, outside = 0;
};

Facts facts(const Mesh& hull, const Mesh& around) {
  Facts facts;
  for (const Triangle& t : hull.triangles) {
    const Vector3 &a = hull.vertices[t[0]], &b = hull.vertices[t[1]], &c = hull.vertices[t[2]];
    const Vector3 vector = (b - a).cross(c - a) / 2;
    facts.flow += vector;
    facts.volume += a.dot(vector) / 3;
    if (vector.norm() < 1e-9) continue;
    for (const Vector3& p : around.vertices) facts.outside = std::max(facts.outside, (p - a).dot(vector.normalized()));
  }
  return facts;
}

}  // namespace

TEST_CASE("a hull is closed, faces outward and holds every point", "[hull]") {
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    const Mesh mesh = random_mesh(random, 12 + 10 * i);
    const Mesh hull = convex_hull(mesh);
    const Facts found = facts(hull, mesh);
    CHECK(found.flow.norm() < 1e-9);
    CHECK(found.volume > 0);
    CHECK(found.outside < 1e-8);
  }
}

TEST_CASE("hulls of solids with a known volume", "[hull]") {
  CHECK(facts(convex_hull(shape("box?x=1&y=2&z=3")), {}).volume == Approx(6));
  const Mesh bowl = shape("sphere?subdivisions=4");
  CHECK(facts(convex_hull(bowl), bowl).volume == Approx(facts(bowl, {}).volume));
}

TEST_CASE("a convex body's silhouette along u is h(u)/2", "[hull]") {
  Random random(6);
  const Mesh hull = convex_hull(random_mesh(random, 60));
  const render::Silhouette silhouette(hull);
  for (int i = 0; i < 20; ++i) {
    const Vector3 u = random_vector(random).normalized();
    double h = 0;
    for (const Triangle& t : hull.triangles)
      h += std::abs(
               (hull.vertices[t[1]] - hull.vertices[t[0]]).cross(hull.vertices[t[2]] - hull.vertices[t[0]]).dot(u)) /
           2;
    const auto area = silhouette.area(u);
    CHECK(area.lower <= h / 2 * (1 + 1e-12));
    CHECK(area.upper >= h / 2 * (1 - 1e-12));
  }
}

TEST_CASE("flat meshes have a hull of two sides, and lines none", "[hull]") {
  Mesh square;
  square.vertices = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1}};
  square.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const Mesh hull = convex_hull(moved(square, rotation_from_euler(0.2, 0.3, 0.4)));
  CHECK(hull.vertices.size() == 4);
  CHECK(facts(hull, square).flow.norm() < 1e-12);
  double area = 0;
  for (const Triangle& t : hull.triangles)
    area += (hull.vertices[t[1]] - hull.vertices[t[0]]).cross(hull.vertices[t[2]] - hull.vertices[t[0]]).norm() / 2;
  CHECK(area == Approx(2));
  Mesh line;
  line.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  line.triangles = {{0, 1, 2}};
  CHECK_THROWS_AS(convex_hull(line), MeshError);
}
