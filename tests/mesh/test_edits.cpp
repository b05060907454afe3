#include <set>

#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/edits.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/run_record.h"
#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

double measured(const Mesh& mesh) {
  const ProjectedArea objective(area_vectors(mesh));
  return run_optimizer(*make_optimizer(certify_method()), objective, {}).merit;
}

Mesh shape(const char* spec) { return make_shape(Spec::parse(spec)); }

std::set<Triangle> faces(const Mesh& mesh) { return {mesh.triangles.begin(), mesh.triangles.end()}; }

}  // namespace

TEST_CASE("Deletion takes the number of faces it says, from those there are", "[edits]") {
  const Mesh sphere = shape("sphere?subdivisions=3");  // 512 faces
  const std::set<Triangle> all = faces(sphere);
  for (const auto& [fraction, left] : {std::pair{0.0, 512}, {0.5, 256}, {0.9, 51}, {0.99, 5}, {1.0, 1}}) {
    const Mesh rest = without_faces(sphere, fraction, Random(3));
    CHECK(rest.triangles.size() == static_cast<std::size_t>(left));
    const std::set<Triangle> some = faces(rest);
    CHECK(some.size() == rest.triangles.size());
    CHECK(std::includes(all.begin(), all.end(), some.begin(), some.end()));
  }
  CHECK(without_faces(sphere, 0, Random(3)).triangles == sphere.triangles);
  CHECK(without_faces(Mesh{}, 0.5, Random(3)).triangles.empty());
}

TEST_CASE("Deletion is seeded, and more deletion takes away the same faces and more", "[edits]") {
  const Mesh sphere = shape("sphere?subdivisions=3");
  const Mesh half = without_faces(sphere, 0.5, Random(3));
  CHECK(half.triangles == without_faces(sphere, 0.5, Random(3)).triangles);
  CHECK(half.triangles != without_faces(sphere, 0.5, Random(4)).triangles);
  const std::set<Triangle> kept = faces(half), fewer = faces(without_faces(sphere, 0.8, Random(3)));
  CHECK(std::includes(kept.begin(), kept.end(), fewer.begin(), fewer.end()));
}

TEST_CASE("Every face is deleted equally often", "[edits]") {
  const Mesh box = shape("box");  // 12 faces
  std::vector<int> kept(12);
  constexpr int kTrials = 4000;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::set<Triangle> some = faces(without_faces(box, 0.75, Random(trial)));
    for (std::size_t i = 0; i < 12; ++i) kept[i] += some.contains(box.triangles[i]);
  }
  // Binomial with mean 1000 and deviation 27: five deviations.
  for (const int count : kept) CHECK(std::abs(count - kTrials / 4) < 5 * 28);
}

TEST_CASE("A mesh of parallel faces keeps R = 1 whatever is deleted", "[edits]") {
  CHECK(measured(without_faces(shape("box?faces=1200&rotate=random"), 0.95, Random(1))) == Approx(1).margin(1e-9));
}

TEST_CASE("Noise is seeded, of the size asked for, and relative to the mesh's extent", "[edits]") {
  const Mesh sphere = shape("sphere?subdivisions=5");  // 8192 faces, 4098 vertices, extent 2
  const Mesh noisy = with_noise(sphere, 0.01, Random(5));
  CHECK(noisy.triangles == sphere.triangles);
  CHECK(noisy.vertices == with_noise(sphere, 0.01, Random(5)).vertices);
  CHECK(noisy.vertices != with_noise(sphere, 0.01, Random(6)).vertices);
  double squares = 0;
  for (std::size_t i = 0; i < sphere.vertices.size(); ++i)
    squares += (noisy.vertices[i] - sphere.vertices[i]).squaredNorm();
  // 12,294 deviates: their variance is known to 1.3 %, so the deviation to 0.65 %; five of these.
  CHECK(std::sqrt(squares / (3.0 * static_cast<double>(sphere.vertices.size()))) == Approx(0.02).epsilon(0.033));

  Mesh large = sphere;
  for (Vector3& p : large.vertices) p *= 1024;
  const Mesh large_noisy = with_noise(large, 0.01, Random(5));
  for (std::size_t i = 0; i < sphere.vertices.size(); ++i)
    REQUIRE(large_noisy.vertices[i] == 1024 * noisy.vertices[i]);  // a power of two: exact
  CHECK(with_noise(sphere, 0, Random(5)).vertices == sphere.vertices);
}

TEST_CASE("Simplification reaches its target and keeps R", "[edits]") {
  const Mesh smooth = shape("ellipsoid?faces=20000");
  const double before = measured(smooth);
  for (const std::size_t target : {10'000, 2000, 200}) {
    const Mesh less = simplified(smooth, target);
    CHECK(less.triangles.size() <= target);
    CHECK(less.triangles.size() >= target * 9 / 10);
    // An inscribed polyhedron of n faces turns each normal by about 1/sqrt(n).
    CHECK(std::abs(measured(less) - before) < 1 / std::sqrt(static_cast<double>(target)));
  }
  CHECK(simplified(smooth, 20'000).triangles.size() == smooth.triangles.size());
}

TEST_CASE("Simplification of flat sides costs nothing", "[edits]") {
  const Mesh box = simplified(shape("box?faces=10000&x=2&rotate=random"), 100);
  CHECK(box.triangles.size() <= 100);
  CHECK(area_vectors(box).area() == Approx(10).epsilon(0.05));  // a few faces fold over
  CHECK(measured(box) == Approx(1).margin(1e-6));
}

TEST_CASE("Simplification takes any soup, at any scale", "[edits]") {
  Mesh doubled = shape("ellipsoid?faces=2000&scale=1e60");
  const Mesh once = simplified(doubled, 500);
  CHECK(once.triangles.size() <= 500);
  // Each face with corners of its own: welded again, the same result.
  Mesh soup;
  for (const Triangle& t : doubled.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    for (const auto corner : t) soup.vertices.push_back(doubled.vertices[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  CHECK(simplified(soup, 500).triangles.size() == once.triangles.size());
  CHECK(simplified(soup, 500).vertices.size() == once.vertices.size());
  CHECK_FALSE(simplified(shape("soup?faces=300"), 3).triangles.empty());
  CHECK(simplified(Mesh{}, 3).triangles.empty());
}
