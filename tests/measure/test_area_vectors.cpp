#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rectilin/base/rotation.h"
#include "rectilin/measure/area_vectors.h"
#include "rectilin/mesh/shapes.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;

namespace {

AreaVectors of_shape(const std::string& spec) { return area_vectors(make_shape(Spec::parse(spec))); }

}  // namespace

TEST_CASE("faces of one direction become one vector, in any pose", "[area_vectors]") {
  for (int seed = 0; seed < 50; ++seed) {
    const std::string pose = "rotate=random&seed=" + std::to_string(seed);
    REQUIRE(of_shape("box?" + pose).size() == 3);
    REQUIRE(of_shape("lshape?" + pose).size() == 3);
    REQUIRE(of_shape("stairs?" + pose).size() == 3);
    REQUIRE(of_shape("pyramid?" + pose).size() == 5);
  }
  REQUIRE(of_shape("box").size() == 3);
}

TEST_CASE("directions that differ by more than rounding stay apart", "[area_vectors]") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vector3 v = test::random_vector(random), w = test::random_vector(random);
    REQUIRE(area_vectors({v, 2 * v, -3 * v}).size() == 1);
    const Vector3 tilted = v + 1e-12 * v.norm() * v.cross(w).normalized();
    REQUIRE(area_vectors({v, tilted}).size() == 2);
  }
}

TEST_CASE("merging keeps the sum of lengths and every projected sum", "[area_vectors]") {
  Random random(4);
  std::vector<Vector3> vectors;
  for (int i = 0; i < 500; ++i) {
    const Vector3 v = test::random_vector(random);
    for (int copies = 0; copies < 4; ++copies) vectors.push_back(v * random.uniform(-2, 2));
  }
  std::shuffle(vectors.begin(), vectors.end(), std::mt19937_64(1));
  const AreaVectors merged = area_vectors(vectors);
  REQUIRE(merged.size() == 500);
  REQUIRE(merged.faces == 2000);
  const auto sum_over = [&](const Vector3& u) {
    double before = 0, after = 0;
    for (const Vector3& v : vectors) before += std::abs(u.dot(v));
    for (std::size_t i = 0; i < merged.size(); ++i) after += std::abs(u.dot(merged[i]));
    return std::pair(before, after);
  };
  double length = 0;
  for (const Vector3& v : vectors) length += v.norm();
  REQUIRE(merged.total == Approx(length).epsilon(1e-13));
  for (int i = 0; i < 100; ++i) {
    const auto [before, after] = sum_over(test::random_vector(random));
    REQUIRE(after == Approx(before).epsilon(1e-13));
  }
}

TEST_CASE("zero vectors weigh nothing", "[area_vectors]") {
  const AreaVectors v = area_vectors({{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}});
  REQUIRE(v.size() == 1);
  REQUIRE(v.faces == 1);
}

TEST_CASE("area comes back in the mesh's unit", "[area_vectors]") {
  Random random(5);
  const Mesh mesh = test::random_mesh(random, 100);
  double area = 0;
  for (const Triangle& t : mesh.triangles)
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
  REQUIRE(area_vectors(mesh).area() == Approx(area).epsilon(1e-13));
  for (const double scale : {0x1p-400, 0x1p+400, 1e-120, 1e120}) {
    const Mesh scaled = test::transformed(mesh, [&](const Vector3& v) -> Vector3 { return v * scale; });
    REQUIRE(area_vectors(scaled).area() == Approx(area * scale * scale).epsilon(1e-13));
  }
}

TEST_CASE("needles are kept apart however thin they are", "[area_vectors]") {
  for (const double width : {1e-3, 1e-75, 1e-100, 1e-160, 1e-250}) {
    INFO(width);
    Mesh fan;  // three triangles round an edge of length 1
    fan.vertices = {{0, 0, 0}, {1, 0, 0}};
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * std::numbers::pi * i / 3;
      fan.vertices.emplace_back(0, width * std::cos(angle), width * std::sin(angle));
      fan.triangles.push_back({0, 1, static_cast<std::uint32_t>(2 + i)});
    }
    const AreaVectors vectors = area_vectors(fan);
    REQUIRE(vectors.size() == 3);
    REQUIRE(vectors.area() == Approx(1.5 * width).epsilon(1e-12));
    REQUIRE(std::hypot(vectors.x[0], vectors.y[0], vectors.z[0]) == Approx(vectors.total / 3).epsilon(1e-12));
  }
}

TEST_CASE("a mesh without area is refused", "[area_vectors]") {
  Mesh line;
  line.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  line.triangles = {{0, 1, 2}};
  REQUIRE_THROWS_AS(area_vectors(line), MeshError);
  REQUIRE_THROWS_AS(area_vectors(Mesh{}), MeshError);
}

TEST_CASE("the same vectors for any number of threads", "[area_vectors]") {
  const Mesh mesh = make_shape(Spec::parse("blob?faces=50000"));
  const AreaVectors reference = area_vectors(mesh);
  for (const std::size_t threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const AreaVectors v = area_vectors(mesh);
    REQUIRE(v.x == reference.x);
    REQUIRE(v.y == reference.y);
    REQUIRE(v.z == reference.z);
    REQUIRE(v.total == reference.total);
  }
}
