// measure(): the one way from a mesh to R, its interval and its pose.
#include <cmath>

#include "rectilin/measure/measure.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/shapes.h"
#include "support/catch.h"
#include "support/known_shapes.h"

using namespace rectilin;

namespace {

Mesh shape(const char* spec) { return make_shape(Spec::parse(spec)); }

}  // namespace

TEST_CASE("a mesh is measured with an interval that holds the known value", "[measure]") {
  const Rectilinearity pyramid = measure(shape("pyramid?rotate=random&seed=3"));
  REQUIRE(pyramid.bounds);
  CHECK(pyramid.bounds->lower <= test::kPyramid);
  CHECK(pyramid.bounds->upper >= test::kPyramid);
  CHECK(pyramid.bounds->width() <= 1e-6);
  CHECK(pyramid.bounds->lower <= pyramid.value);
  CHECK(pyramid.faces == 6);
  CHECK(pyramid.directions == 5);
  CHECK(pyramid.certificate == std::nullopt);
  CHECK(ProjectedArea(area_vectors(shape("pyramid?rotate=random&seed=3"))).value(pyramid.rotation) ==
        Approx(3 / (test::kPyramid + 2)).epsilon(1e-9));
}

TEST_CASE("every face of a turned box is parallel to two axes of its pose", "[measure]") {
  const Mesh box = shape("box?x=2&y=3&rotate=random&seed=9");
  const Rectilinearity r = measure(box);
  CHECK(r.value == Approx(1).margin(1e-12));
  CHECK(r.area == Approx(22));
  for (const ParallelFaces& axis : r.parallel_faces) {
    CHECK(axis.count == 8);  // of 12 triangles the four on the other sides are not
    CHECK(axis.first.size() == 8);
  }
}

TEST_CASE("a face is parallel to an axis up to a billionth of a radian", "[measure]") {
  for (const double scale : {1., 1e-150, 1e150})
    for (const double width : {1., 1e-6})  // of the face: its edges are at about 45 degrees, or it is a needle
      for (const double angle : {0., 1e-12, 5e-10, 2e-9, 1e-7, 0.1}) {
        INFO(scale << " " << width << " " << angle);
        Mesh mesh = shape("box?x=2&y=3");
        const auto corner = static_cast<std::uint32_t>(mesh.vertices.size());
        const Vector3 along(std::cos(angle), std::sin(angle), 0), up(0, 0, 1e-3);
        for (const Vector3& v : {Vector3(0, 0, 0), up, Vector3(up + 1e-3 * width * along)}) mesh.vertices.push_back(v);
        mesh.triangles.push_back({corner, corner + 1, corner + 2});
        for (Vector3& v : mesh.vertices) v *= scale;
        std::size_t parallel = 0, axes = 0;
        for (const ParallelFaces& axis : measure(mesh).parallel_faces) {
          parallel += axis.count;
          axes += axis.count > 8;
        }
        CHECK(parallel == 24 + (angle < 1e-9 ? 2 : 1));  // the small face is parallel to z, and perhaps to x
        CHECK(axes == (angle < 1e-9 ? 2 : 1));
      }
}

TEST_CASE("a certificate is written if it is asked for, and the checker accepts it", "[measure]") {
  const Mesh mesh = shape("prism?sides=5&rotate=random");
  const Rectilinearity r = measure(mesh, {.certificate = true});
  REQUIRE(r.certificate);
  const Verdict verdict = verify_certificate(to_text(to_json(*r.certificate, mesh_digest(mesh))), mesh);
  CHECK(verdict.accepted);
  CHECK(verdict.lower == Approx(r.bounds->lower).margin(1e-9));
}

TEST_CASE("every optimizer measures; bounds are there where something is proved", "[measure]") {
  const Mesh mesh = shape("prism?sides=3");
  const Rectilinearity proved = measure(mesh, measure_options("certify?gap=1e-8"));
  CHECK(proved.bounds->width() <= 1e-8);
  const Rectilinearity searched = measure(mesh, measure_options("ga?population=20&generations=5"));
  CHECK_FALSE(searched.bounds);
  CHECK(searched.value <= proved.bounds->upper);
  CHECK(searched.run.costs.evaluations() == 100);
  const Rectilinearity both = measure(mesh, measure_options("random?evaluations=50+certify"));
  CHECK(both.bounds->upper >= proved.bounds->lower);
  CHECK_THROWS_AS(measure_options("certify?gap=-1"), ParameterError);
  CHECK_THROWS_WITH(measure_options("certfy"), Catch::Contains("did you mean 'certify'?"));
}

TEST_CASE("its JSON says what the value says", "[measure]") {
  const Rectilinearity r = measure(shape("cut-cube"), measure_options("certify?optima=true"));
  const Json json = to_json(r);
  CHECK(json["rectilinearity"] == r.value);
  CHECK(json["lower"] == r.bounds->lower);
  CHECK(json["upper"] == r.bounds->upper);
  CHECK(json["faces"] == r.faces);
  CHECK(json["optima"].size() == r.proof->optima.size());
  CHECK(to_json(measure(shape("box"), measure_options("grid")))["lower"].is_null());
}

TEST_CASE("what cannot be measured is an error in one line", "[measure]") {
  CHECK_THROWS_AS(measure(Mesh{}), MeshError);
  MeasureOptions broke;
  broke.run.budget.evaluations = 1;  // a cut costs two
  CHECK_THROWS_WITH(measure(shape("box"), broke), "the budget ends before the first rotation");
}
