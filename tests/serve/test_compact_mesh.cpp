// Meshes as the viewer gets them.
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"
#include "rectilin/retrieval/model.h"
#include "shapes/compact_mesh.h"
#include "support/catch.h"

using namespace rectilin;
using serve::compact_mesh;
using serve::mesh_of_compact;

namespace {

Mesh in_unit_ball(const std::string& shape) {
  const Mesh mesh = load_mesh(shape).mesh;
  return retrieval::transformed(mesh, retrieval::surface_frame(mesh));
}

}  // namespace

TEST_CASE("A compact mesh is the mesh to a part in 65000", "[serve]") {
  Mesh mesh = in_unit_ball("shape:torus?minor=0.3");
  const std::size_t used = mesh.vertices.size();
  mesh.vertices.push_back({9, 9, 9});  // that no triangle uses
  const std::string bytes = compact_mesh(mesh);
  CHECK(bytes.size() == 16 + 12 * mesh.triangles.size() + 6 * used);
  const Mesh back = mesh_of_compact(bytes);
  REQUIRE(back.triangles.size() == mesh.triangles.size());
  double farthest = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      farthest = std::max(
          farthest, (back.vertices[back.triangles[i][k]] - mesh.vertices[mesh.triangles[i][k]]).cwiseAbs().maxCoeff());
  CHECK(farthest <= 0.5001 / 32767);
}

TEST_CASE("A large mesh is simplified for the viewer", "[serve]") {
  const Mesh mesh = in_unit_ball("shape:torus?slices=600&stacks=300");
  REQUIRE(mesh.triangles.size() > serve::kMostShown);
  const Mesh back = mesh_of_compact(compact_mesh(mesh));
  CHECK(back.triangles.size() <= serve::kMostShown);
  CHECK(back.triangles.size() > serve::kMostShown / 2);
}

TEST_CASE("Bytes that are no compact mesh are refused", "[serve]") {
  const std::string bytes = compact_mesh(in_unit_ball("shape:box"));
  CHECK_NOTHROW(mesh_of_compact(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_THROWS_AS(mesh_of_compact(bytes.substr(0, size)), MeshError);
  CHECK_THROWS_AS(mesh_of_compact(bytes + "x"), MeshError);
  std::string wrong = bytes;
  wrong[16] = '\x7f';  // an index
  CHECK_THROWS_AS(mesh_of_compact(wrong), MeshError);
  wrong = bytes;
  wrong[7] = '\x7f';  // the number of vertices
  CHECK_THROWS_AS(mesh_of_compact(wrong), MeshError);
}
