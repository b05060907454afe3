// Duplicates: copies in other poses, sizes and tessellations are found, mirror images told apart, others left alone.
#include <Eigen/Geometry>
#include <filesystem>
#include <limits>

#include "alignment.h"
#include "rectilin/base/random.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/mesh_io.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/duplicates.h"
#include "rectilin/search/index.h"
#include "support/catch.h"
#include "support/scratch_folder.h"
#include "support/subdivided.h"

using namespace rectilin;
using namespace rectilin::search;
namespace fs = std::filesystem;

namespace {

/// Three arms of different lengths at right angles, each other in width: its mirror image is another shape.
Mesh chiral() {
  Mesh all;
  const auto add = [&](Vector3 low, Vector3 high) {
    const auto base = static_cast<std::uint32_t>(all.vertices.size());
    for (int k = 0; k < 8; ++k)
      all.vertices.emplace_back(k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(), k & 4 ? high.z() : low.z());
    for (const auto& t : {Triangle{0, 1, 3},
                          {0, 3, 2},
                          {4, 6, 7},
                          {4, 7, 5},
                          {0, 4, 5},
                          {0, 5, 1},
                          {2, 3, 7},
                          {2, 7, 6},
                          {0, 2, 6},
                          {0, 6, 4},
                          {1, 5, 7},
                          {1, 7, 3}})
      all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  };
  add({0, 0, 0}, {3, 1, 1});
  add({0, 1, 0}, {0.8, 3, 0.6});
  add({0.2, 0.1, 1}, {0.7, 0.9, 2});
  return all;
}

Mesh moved(Mesh mesh, Random& random, bool mirror = false) {
  const Eigen::Matrix3d turn = random_rotation(random).matrix() * random.uniform(0.01, 90);
  const Vector3 shift(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50));
  for (Vector3& v : mesh.vertices) v = turn * (mirror ? Vector3(-v.x(), v.y(), v.z()) : v) + shift;
  return mesh;
}

}  // namespace

TEST_CASE("a fit finds the way back, and a reflection only where there is one") {
  Random random(2);
  const AlignedShape first{retrieval::Model(chiral())};
  for (int i = 0; i < 3; ++i) {
    const AlignedShape copy{retrieval::Model(moved(test::subdivided(chiral()), random))};
    CHECK(best_fit(first, copy, false).distance < 1e-4);
    CHECK(best_fit(first, copy, true).distance > 0.03);
    const AlignedShape mirror{retrieval::Model(moved(chiral(), random, true))};
    CHECK(best_fit(first, mirror, true).distance < 1e-4);
    CHECK(best_fit(first, mirror, false).distance > 0.03);
  }
  const AlignedShape torus{retrieval::Model(load_mesh("shape:torus").mesh)};
  CHECK(best_fit(first, torus, false).distance > 0.05);
}

TEST_CASE("a foot is the nearest point of the surface") {
  // Against all triangles one by one.
  Random random(7);
  std::vector<SurfaceTree::Corners> triangles;
  for (int i = 0; i < 300; ++i) {
    const Vector3 at(random.normal(), random.normal(), random.normal());
    SurfaceTree::Corners t;
    for (Vector3& corner : t) corner = at + 0.3 * Vector3(random.normal(), random.normal(), random.normal());
    switch (i % 20) {  // some without area
      case 0:
        t[2] = t[1];
        break;
      case 1:
        t[1] = t[0];
        break;
      case 2:
        t[2] = t[0];
        break;
      case 3:
        t[1] = t[2] = t[0];
        break;
      case 4:
        t[2] = (t[0] + t[1]) / 2;
        break;
    }
    triangles.push_back(t);
  }
  const SurfaceTree tree(triangles);
  for (int i = 0; i < 300; ++i) {
    const Vector3 p(2 * random.normal(), 2 * random.normal(), 2 * random.normal());
    double least = std::numeric_limits<double>::infinity();
    for (const auto& t : triangles) {
      least = std::min(least, (nearest_of_triangle(p, t) - p).norm());
      // No point of the triangle is nearer than the one found.
      const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
      const Vector3 q = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      CHECK((nearest_of_triangle(p, t) - p).norm() <= (q - p).norm() + 1e-12);
    }
    const SurfaceTree::Foot foot = tree.nearest(p);
    CHECK(foot.distance == Approx(least).epsilon(1e-12));
    CHECK((foot.point - p).norm() == Approx(least).epsilon(1e-12));
    CHECK(std::isinf(tree.nearest(p, least * 0.999).distance));
    CHECK(tree.nearest(p, least * 1.001).distance == foot.distance);
  }
  CHECK(std::isinf(SurfaceTree({}).nearest(Vector3::Zero()).distance));
}

TEST_CASE("vertices tell a simplified copy from another shape") {
  Random random(9);
  const Mesh fine = load_mesh("shape:torus?minor=0.4").mesh;
  const AlignedShape first{retrieval::Model(fine)};
  const AlignedShape copy{retrieval::Model(moved(simplified(fine, fine.triangles.size() / 20), random))};
  const AlignedShape other{retrieval::Model(moved(load_mesh("shape:torus?minor=0.45").mesh, random))};
  CHECK(vertex_fit(first, copy, best_fit(first, copy, false)).share > 0.99);
  CHECK(vertex_fit(first, other, best_fit(first, other, false)).share < 0.1);
  // A box fits into a longer one with all vertices on its surface, but not on its vertices.
  const AlignedShape box{retrieval::Model(load_mesh("shape:box?x=2&y=1.2").mesh)};
  const AlignedShape longer{retrieval::Model(load_mesh("shape:box?x=2&y=1.4").mesh)};
  CHECK(vertex_fit(longer, box, best_fit(longer, box, false)).share <= 0.5);
}

TEST_CASE("a placement takes one file's coordinates to another's") {
  Random random(12);
  for (const bool mirror : {false, true}) {
    const Mesh mesh = chiral(), copy = moved(mesh, random, mirror);
    const AlignedShape first{retrieval::Model(mesh)}, second{retrieval::Model(copy)};
    const Placement back = placement(first, second, best_fit(first, second, mirror));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      CHECK((back.linear * copy.vertices[i] + back.shift - mesh.vertices[i]).norm() < 1e-3);
    CHECK((back.linear.determinant() < 0) == mirror);
  }
}

TEST_CASE("groups of a folder") {
  const test::ScratchFolder scratch;
  Random random(4);
  const auto put = [&](const std::string& name, const Mesh& mesh) { write_mesh(scratch.path() / name, mesh); };
  put("a1.off", chiral());
  put("a2.ply", moved(test::subdivided(chiral()), random));
  put("a3.off", moved(chiral(), random, true));
  put("b1.obj", load_mesh("shape:stairs?steps=4").mesh);
  put("b2.off", moved(load_mesh("shape:stairs?steps=4").mesh, random));
  put("c.off", load_mesh("shape:stairs?steps=6").mesh);
  put("d.off", load_mesh("shape:torus").mesh);
  fs::copy_file(scratch.path() / "d.off", scratch.path() / "e.off");
  Database database(scratch.path() / "shapes.db", "best");
  CHECK(update_index(database, {scratch.path().string()}).errors.empty());
  const Duplicates found = find_duplicates(database);
  CHECK(found.complete);
  std::vector<std::string> groups;
  for (const DuplicateGroup& group : found.groups) {
    std::string text;
    for (std::size_t k = 0; k < group.members.size(); ++k)
      text += fs::path(found.members[group.members[k]].name).stem().string() + (group.mirrored[k] ? "~ " : " ");
    groups.push_back(text);
    CHECK(group.evidence.size() + 1 == group.members.size());
  }
  CHECK(groups == std::vector<std::string>{"a1 a2 a3~ ", "b1 b2 ", "d e "});
}

TEST_CASE("a few vertices in common say nothing") {
  // Seven of each ten are the same, the corners of a cube; the surfaces are further apart than the tolerance.
  const test::ScratchFolder scratch;
  write_mesh(scratch.path() / "a.off", load_mesh("shape:cut-cube?depth=0.15").mesh);
  write_mesh(scratch.path() / "b.off", load_mesh("shape:cut-cube?depth=0.2").mesh);
  Database database(scratch.path() / "shapes.db", "gsmd?views=6");
  CHECK(update_index(database, {scratch.path().string()}).errors.empty());
  const Duplicates found = find_duplicates(database, {.shared = 0.6});
  CHECK(found.pairs_looked_at == 1);
  CHECK(found.groups.empty());
}
