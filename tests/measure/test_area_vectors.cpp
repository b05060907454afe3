#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rectilin/base/rotation.h"
#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/mesh/shapes.h"
#include "support/catch.h"
#include "support/random_meshes.h"

using namespace rectilin;

namespace {

AreaVectors of_shape(const std::string& spec) { return area_vectors(make_shape(Spec::parse(spec))); }

void require_same(const AreaVectors& a, const AreaVectors& b) {
  REQUIRE(a.x == b.x);
  REQUIRE(a.y == b.y);
  REQUIRE(a.z == b.z);
  REQUIRE(a.total == b.total);
}

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

TEST_CASE("many vectors of directions that are close together are told apart", "[area_vectors]") {
  Random random(5);
  for (int trial = 0; trial < 30; ++trial) {
    const Vector3 v = test::random_vector(random).normalized();
    std::vector<Vector3> vectors;
    for (int direction = 0; direction < 25; ++direction) {
      const Vector3 tilted = v + 1e-7 * test::random_vector(random);
      for (int copies = 0; copies < 40; ++copies) vectors.push_back(tilted * random.uniform(-2, 2));
    }
    std::shuffle(vectors.begin(), vectors.end(), std::mt19937_64(1));
    REQUIRE(area_vectors(std::move(vectors)).size() == 25);
  }
}

TEST_CASE("vectors that are close together are told apart whether or not equal ones are neighbours", "[area_vectors]") {
  Random random(15);
  for (int trial = 0; trial < 30; ++trial) {
    const Vector3 v = test::random_vector(random).normalized();
    std::vector<Vector3> runs;
    double length = 0;
    for (int direction = 0; direction < 12; ++direction) {
      const Vector3 tilted = ((v + 1e-8 * test::random_vector(random)) * 0x1p40).array().round() * 0x1p-40;
      for (int copies = 0; copies <= 5 * direction; ++copies) {
        runs.push_back(tilted * (copies % 3 ? 1 : -4));  // a power of two, so that the directions are equal bit for bit
        length += runs.back().norm();
      }
    }
    std::vector<Vector3> shuffled = runs;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(static_cast<unsigned>(trial)));
    const AreaVectors a = area_vectors(std::move(runs)), b = area_vectors(std::move(shuffled));
    REQUIRE(a.size() == 12);
    REQUIRE(a.total == Approx(length).epsilon(1e-14));
    require_same(a, b);  // vectors of so few digits add up without rounding
  }
}

TEST_CASE("a few vectors of directions that are close together are told apart", "[area_vectors]") {
  Random random(6);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3 v = test::random_vector(random).normalized();
    const Vector3 a = v + 1e-8 * test::random_vector(random), b = v + 1e-8 * test::random_vector(random);
    REQUIRE(area_vectors({a, b}).size() == 2);
    REQUIRE(area_vectors({a, b, 3 * a, -2 * b}).size() == 2);
    REQUIRE(area_vectors({a, 2 * a, b, 0.7 * b, -a, 0.3 * a, 0.1 * b}).size() == 2);
  }
}

TEST_CASE("neighbours have similar directions", "[area_vectors]") {
  Random random(12);
  for (const std::size_t size : {2000u, 20'000u}) {
    INFO(size);
    std::vector<Vector3> vectors(size);
    for (Vector3& v : vectors) v = test::random_vector(random).normalized();
    const AreaVectors sorted = area_vectors(std::move(vectors));
    double sines = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) sines += sorted[i - 1].cross(sorted[i]).norm();
    const double spacing = std::sqrt(2 * std::numbers::pi / static_cast<double>(size));
    REQUIRE(sines < 1.1 * spacing * static_cast<double>(size));
  }
}

TEST_CASE("the same vectors for any instruction set", "[area_vectors]") {
  const Mesh mesh = make_shape(Spec::parse("blob?faces=50000"));
  const AreaVectors reference = area_vectors(mesh);
  for (const std::string& name : instruction_sets()) {
    INFO(name);
    const ScopedInstructionSet target(name);
    require_same(area_vectors(mesh), reference);
  }
}

TEST_CASE("vectors may be of any scale, but must be finite", "[area_vectors]") {
  Random random(14);
  std::vector<Vector3> vectors;
  for (int i = 0; i < 50; ++i) vectors.push_back(test::random_vector(random));
  const double area = area_vectors(vectors).area();
  for (const double scale : {1e-300, 1e-100, 1e-30, 1e30, 1e100, 1e300}) {
    INFO(scale);
    std::vector<Vector3> scaled = vectors;
    for (Vector3& v : scaled) v *= scale;
    const AreaVectors result = area_vectors(std::move(scaled));
    REQUIRE(result.size() == 50);
    REQUIRE(result.area() == Approx(area * scale).epsilon(1e-13));
  }
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    vectors[20].y() = bad;
    REQUIRE_THROWS_AS(area_vectors(vectors), MeshError);
  }
}

TEST_CASE("zero vectors weigh nothing", "[area_vectors]") {
  const AreaVectors v = area_vectors({{0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}});
  REQUIRE(v.size() == 1);
  REQUIRE(v.faces == 1);
  Random random(17);
  for (const std::size_t size : {100u, 9000u}) {
    std::vector<Vector3> some, mixed(size / 3, Vector3::Zero());
    for (std::size_t i = 0; i < size; ++i) {
      some.push_back(test::random_vector(random));
      mixed.push_back(some.back());
      if (i % 3 == 0) mixed.emplace_back(0, -0.0, 0);
    }
    const AreaVectors a = area_vectors(std::move(some)), b = area_vectors(std::move(mixed));
    require_same(a, b);
    REQUIRE(b.faces == size);
  }
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
    require_same(area_vectors(mesh), reference);
  }
}

TEST_CASE("normals count by direction and weight, not by length or side", "[area_vectors]") {
  Random random(8);
  std::vector<Vector3> normals;
  std::vector<double> weights;
  std::vector<Vector3> vectors;
  for (int i = 0; i < 40; ++i) {
    const Vector3 unit = test::random_vector(random).normalized();
    normals.push_back(unit * random.uniform(-1e3, 1e3));
    weights.push_back(random.uniform(0, 5));
    vectors.push_back(unit * weights.back());
  }
  const AreaVectors of_normals = area_vectors_of_normals(normals, weights), plain = area_vectors(vectors);
  REQUIRE(of_normals.size() == plain.size());
  REQUIRE(of_normals.area() == Approx(plain.area()).epsilon(1e-14));
  for (int i = 0; i < 20; ++i) {
    const Vector3 u = test::random_vector(random).normalized();
    const auto sum = [&](const AreaVectors& v) {
      double h = 0;
      for (std::size_t k = 0; k < v.size(); ++k) h += std::abs(u.dot(v[k]));
      return h / v.total;
    };
    REQUIRE(sum(of_normals) == Approx(sum(plain)).epsilon(1e-13));
  }
  REQUIRE(area_vectors_of_normals(std::vector<Vector3>(3, Vector3::UnitX())).area() == 3);
  const std::vector<double> tiny(1, 1e-300);
  REQUIRE(area_vectors_of_normals(std::vector<Vector3>{Vector3(1e-200, 0, 0)}, tiny).area() == Approx(1e-300));
}

TEST_CASE("normals that are none are refused with their place", "[area_vectors]") {
  const std::vector<Vector3> two = {Vector3::UnitX(), Vector3::Zero()}, one = {Vector3::UnitX()};
  CHECK_THROWS_WITH(area_vectors_of_normals(two), "normal 1 is zero or not finite");
  CHECK_THROWS_WITH(area_vectors_of_normals(one, std::vector<double>{-1}), "weight 0 is negative or not finite");
  CHECK_THROWS_WITH(area_vectors_of_normals(one, std::vector<double>{1, 1}), "there are 1 normals and 2 weights");
  CHECK_THROWS_WITH(area_vectors_of_normals(one, std::vector<double>{0}), "the normals have no weight");
  CHECK_THROWS_AS(area_vectors_of_normals({}), MeshError);
}

TEST_CASE("a mesh has the vectors that its triangles have one by one", "[area_vectors]") {
  Random random(16);
  for (const int triangles : {1, 511, 512, 513, 9000}) {
    INFO(triangles);
    Mesh mesh = test::random_mesh(random, triangles);
    for (Vector3& v : mesh.vertices) v = (v * 0x1p16).array().round() * 0x1p-16;  // few digits: nothing is rounded
    std::vector<Vector3> vectors;
    for (const Triangle& t : mesh.triangles) {
      const Vector3& origin = mesh.vertices[t[0]];
      vectors.push_back(0.5 * (mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
    }
    require_same(area_vectors(mesh), area_vectors(std::move(vectors)));
  }
}

TEST_CASE("a mesh is looked at where it lies", "[area_vectors]") {
  const Mesh mesh = make_shape(Spec::parse("blob?faces=300"));
  const AreaVectors of_mesh = area_vectors(mesh), of_view = area_vectors(MeshView(mesh.vertices, mesh.triangles));
  REQUIRE(of_mesh.x == of_view.x);
  std::vector<Vector3> vertices = mesh.vertices;
  vertices[mesh.triangles[5][1]].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(area_vectors(MeshView(vertices, mesh.triangles)), MeshError);
}
