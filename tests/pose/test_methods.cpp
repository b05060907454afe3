// Every method: known solids, invariance, meshes that have no pose.
#include <tbb/global_control.h>

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "pose_support.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "rectilin/pose/roundness.h"
#include "rectilin/pose/summed_silhouette.h"
#include "support/catch.h"
#include "support/surface.h"

using namespace rectilin;
using namespace rectilin::test;
using pose::Uniqueness;

namespace {

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto& entry : pose::pose_methods().entries()) names.push_back(entry.name);
  return names;
}

}  // namespace

TEST_CASE("a bracket: every method that should find its axes does", "[pose]") {
  const Rotation turn = rotation_from_euler(0.4, 1.1, 2.3);
  const Mesh mesh = moved(bracket(), turn, 7, {100, -30, 20});
  for (const std::string name :
       {"normal-pca", "rectilinear", "symmetry", "silhouette", "cpn", "cpn?pixels=false", "composite"}) {
    INFO(name);
    const double angle = frame_angle(pose_of(name, mesh).rotation, turn.inverse());
    CHECK(angle < (name == "silhouette" ? 1 * kDegree : 1e-6));
  }
}

TEST_CASE("normalised meshes are centred and of size one", "[pose]") {
  Random random(3);
  for (const std::string& name : names()) {
    INFO(name);
    const Mesh mesh = moved(bracket(), random_rotation(random), 1e5, {3e5, 2e5, 1e5});
    const pose::Pose found = pose_of(name, mesh);
    CHECK((found.rotation.matrix() * found.rotation.matrix().transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
    CHECK(found.rotation.matrix().determinant() == Approx(1));
    const Mesh upright = pose::normalized(mesh, found);
    double furthest = 0;
    for (const Vector3& v : upright.vertices) furthest = std::max(furthest, v.norm());
    CHECK(furthest == Approx(1).epsilon(1e-9));
    CHECK(pose_of("pca", upright).centre.norm() < 1e-9);
    CHECK(found.chosen == found.candidates.front().name);
    CHECK(frame_angle(found.rotation, found.candidates.front().rotation) < 1e-12);
  }
}

TEST_CASE("a pose turns, moves and grows with the mesh", "[pose]") {
  Random random(12);
  for (const std::string& name : names()) {
    if (name == "silhouette") continue;  // a search that ends when its steps are small
    INFO(name);
    const Mesh mesh =
        together(bracket(), moved(shape("pyramid"), rotation_from_euler(0.1, 0.2, 0.3), 0.8, {-1, 0.6, 0}));
    const pose::Pose first = pose_of(name, mesh);
    REQUIRE(first.uniqueness == Uniqueness::kUnique);
    for (int i = 0; i < 4; ++i) {
      const Rotation turn = random_rotation(random);
      const double scale = std::pow(10.0, random.uniform(-3, 3));
      const Vector3 by = scale * random_vector(random);
      const pose::Pose again = pose_of(name, moved(mesh, turn, scale, by));
      CHECK(frame_angle(again.rotation * turn, first.rotation) < 1e-6);
      CHECK(again.scale * scale == Approx(first.scale));
      CHECK((again.centre - (scale * (turn.matrix() * first.centre) + by)).norm() < 1e-9 * scale);
    }
  }
}

TEST_CASE("the same bits for any number of threads", "[pose]") {
  const Mesh mesh = moved(shape("blob?faces=3000"), rotation_from_euler(0.3, 0.2, 0.1));
  for (const std::string name : {"composite", "cpn", "cpn?pixels=false", "box"}) {
    const pose::Pose many = pose_of(name, mesh);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const pose::Pose alone = pose_of(name, mesh);
    INFO(name);
    CHECK(many.rotation.matrix() == alone.rotation.matrix());
    CHECK(many.confidence == alone.confidence);
  }
}

TEST_CASE("the hull's rectilinear pose minimises the hull's silhouettes", "[pose]") {
  Random random(14);
  const Mesh mesh = random_mesh(random, 40);
  const pose::Pose found = pose_of("hull", mesh);
  const pose::SummedSilhouette silhouettes(mesh);  // of the mesh itself: no larger
  double own = 0;
  silhouettes.values({&found.rotation, 1}, {&own, 1});
  CHECK(own <= found.candidates.front().projected * (1 + 1e-6));
}

TEST_CASE("the least box round a regular tetrahedron is a cube", "[pose]") {
  // Known to be the hard case for searches from the hull's faces: no face of the tetrahedron lies on the cube's.
  Mesh mesh;
  mesh.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const pose::Pose found = pose_of("box", moved(mesh, rotation_from_euler(0.3, 0.6, 0.9)));
  const double area = 8 * std::sqrt(3.0);  // four faces of edge 2 sqrt(2)
  CHECK(found.candidates.front().volume.value() * std::pow(area, 1.5) == Approx(8).epsilon(1e-6));
}

TEST_CASE("the volume of a box is that of the frame it comes with", "[pose]") {
  Random random(15);
  for (int i = 0; i < 4; ++i) {
    const Mesh mesh = moved(random_mesh(random, 12), random_rotation(random));
    const pose::Pose found = pose_of("box", mesh);
    for (const pose::PoseCandidate& candidate : found.candidates) {
      Vector3 lower = candidate.rotation.matrix() * mesh.vertices.front(), upper = lower;
      for (const Vector3& v : mesh.vertices) {
        lower = lower.cwiseMin(candidate.rotation.matrix() * v);
        upper = upper.cwiseMax(candidate.rotation.matrix() * v);
      }
      CHECK(candidate.volume.value() * std::pow(surface(mesh), 1.5) == Approx((upper - lower).prod()).epsilon(1e-9));
    }
  }
}

TEST_CASE("bodies of revolution and spheres say so", "[pose]") {
  CHECK(pose::unroundness(shape("cylinder?sides=64"), Vector3::UnitZ()) < 0.01);
  CHECK(pose::unroundness(shape("box?x=1&y=2&z=3"), Vector3::UnitZ()) > 0.3);
  const Rotation turn = rotation_from_euler(0.5, 0.3, 0.9);
  const Mesh cone = moved(shape("ellipsoid?a=3&b=1&c=1&faces=8000"), turn);
  for (const std::string name : {"pca", "normal-pca", "rectilinear", "hull", "box", "symmetry", "cpn", "composite"}) {
    INFO(name);
    const pose::Pose found = pose_of(name, cone);
    CHECK(found.uniqueness == Uniqueness::kContinuum);
    REQUIRE(found.free_axis >= 0);
    CHECK(std::abs(found.rotation.axis(found.free_axis).dot(turn.matrix().col(0))) > std::cos(1 * kDegree));
    CHECK(pose_of(name, shape("sphere?kind=even&faces=5000")).uniqueness == Uniqueness::kNone);
  }
  CHECK(pose_of("silhouette?evaluations=20", shape("sphere?kind=even&faces=2000")).uniqueness == Uniqueness::kNone);
}

TEST_CASE("flat meshes, single triangles, parts far apart and huge numbers", "[pose]") {
  Mesh triangle;
  triangle.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  const Mesh apart = together(shape("box?x=1&y=2&z=3"), moved(shape("box"), Rotation(), 1, {1e6, 0, 0}));
  const Mesh flat = transformed(shape("blob?faces=500"), [](const Vector3& v) { return Vector3(v.x(), v.y(), 0); });
  const Mesh huge = moved(bracket(), Rotation(), 1e120), tiny = moved(bracket(), Rotation(), 1e-120);
  for (const std::string& name : names()) {
    INFO(name);
    for (const Mesh* mesh : std::initializer_list<const Mesh*>{&triangle, &apart, &flat, &huge, &tiny}) {
      const pose::Pose found = pose_of(name, *mesh);
      CHECK(found.rotation.matrix().allFinite());
      CHECK(found.centre.allFinite());
      CHECK(std::isfinite(found.scale));
      CHECK(std::isfinite(found.confidence));
      for (const Vector3& v : pose::normalized(*mesh, found).vertices) CHECK(v.norm() <= 1 + 1e-9);
    }
    CHECK(frame_angle(pose_of(name, huge).rotation, pose_of(name, bracket()).rotation) < 1e-6);
    Mesh line = triangle;
    line.vertices[2] = {2, 0, 0};
    CHECK_THROWS_AS(pose_of(name, line), MeshError);
  }
}

TEST_CASE("silhouettes never exceed projections, and convex ones are half", "[pose]") {
  Random random(15);
  const Mesh mesh = shape("torus?slices=20&stacks=10");
  const pose::SummedSilhouette silhouettes(mesh);
  const ProjectedArea projections(area_vectors(mesh));
  for (int i = 0; i < 10; ++i) {
    const Rotation frame = random_rotation(random);
    double s = 0, p = 0;
    silhouettes.values({&frame, 1}, {&s, 1});
    projections.values({&frame, 1}, {&p, 1});
    CHECK(s <= p / 2 * (1 + 1e-6));  // a closed surface is crossed twice at least
  }
}

TEST_CASE("poses of real models turn with them", "[pose][data]") {
  const char* data = std::getenv("RECTILIN_DATA");
  if (!data) {
    WARN("RECTILIN_DATA is not set: no real models");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(data) / "psb" / "off";
  if (!std::filesystem::exists(folder)) {
    WARN("no " + folder.string());
    return;
  }
  std::vector<std::string> models = expand_folders({folder.string()});
  Random random(16);
  int unique = 0;
  for (std::size_t i = 0; i < models.size(); i += models.size() / 25 + 1) {
    const Mesh mesh = load_mesh(models[i]).mesh;
    if (mesh.triangles.size() > 20'000) continue;
    for (const std::string name : {"pca", "rectilinear", "hull", "cpn", "composite"}) {
      const pose::Pose first = pose_of(name, mesh);
      if (first.uniqueness != Uniqueness::kUnique) continue;
      const Rotation turn = random_rotation(random);
      const pose::Pose again = pose_of(name, moved(mesh, turn, 3, {1, 2, 3}));
      INFO(models[i] << " by " << name << ", confidence " << first.confidence);
      CHECK(frame_angle(again.rotation * turn, first.rotation) < 1e-6);
      ++unique;
    }
  }
  CHECK(unique > 50);
}
