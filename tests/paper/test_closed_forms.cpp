// The closed forms against the certified solver, and against each other in the limits.
#include <cmath>
#include <numbers>

#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/certify.h"
#include "rectilin/paper/closed_forms.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::paper;
using std::numbers::pi;

namespace {

constexpr double kFormRounding = 1e-11;  // of R: three sums of 1e-12

/// Is `expected` within the certified bounds of R?
void require_certified(AreaVectors vectors, double expected, double gap = 1e-6) {
  const ProjectedArea objective(std::move(vectors));
  Evaluator evaluator(objective);
  CertifyOptions options;
  options.gap = gap;
  const CertifyResult result = certify(evaluator, options);
  INFO("expected " << expected);
  REQUIRE(result.closed);
  REQUIRE(expected >= rectilinearity(result.incumbent.value) - kFormRounding);
  REQUIRE(expected <= rectilinearity(result.lower) + kFormRounding);
}

std::string with(const std::string& text, double x) { return text + Json(x).dump(); }

double certified(const std::string& source, double gap = 1e-6) {
  const ProjectedArea objective(area_vectors(load_mesh(source).mesh));
  Evaluator evaluator(objective);
  CertifyOptions options;
  options.gap = gap;
  return rectilinearity(certify(evaluator, options).incumbent.value);
}

}  // namespace

TEST_CASE("boxes have R = 1 in any pose", "[closed-forms]") {
  for (const char* box : {"x=1", "x=0.01&y=3", "z=7&y=0.2"})
    require_certified(area_vectors(load_mesh(std::string("shape:box?rotate=random&seed=4&") + box).mesh), 1);
}

TEST_CASE("the pyramid's closed form is the certified optimum", "[closed-forms]") {
  REQUIRE(pyramid_rectilinearity(1, 1) == Approx(3 * (1 + std::sqrt(5.0)) / 4 - 2).margin(1e-15));
  REQUIRE(pyramid_rectilinearity(3, 6) == Approx(pyramid_rectilinearity(1, 2)).margin(1e-15));
  for (double height = 0.02; height < 60; height *= 1.23)
    require_certified(area_vectors(load_mesh(with("shape:pyramid?rotate=random&seed=9&height=", height)).mesh),
                      pyramid_rectilinearity(1, height), 1e-9);
}

TEST_CASE("the prism's closed form is the certified optimum", "[closed-forms]") {
  REQUIRE(prism_rectilinearity(4, 0.3, 2) == Approx(1).margin(1e-14));
  for (int sides = 3; sides <= 20; ++sides)
    for (const double height : {0.01, 0.3, 1.0, 4.0, 100.0})
      for (const bool caps : {true, false}) {
        std::string source = "shape:prism?sides=" + std::to_string(sides);
        source += caps ? "&caps=true" : "&caps=false";
        require_certified(area_vectors(load_mesh(with(source + "&height=", height)).mesh),
                          prism_rectilinearity(sides, 0.5, height, caps));
      }
}

TEST_CASE("prisms tend to the cylinder like the square of the angle between walls", "[closed-forms]") {
  for (const int sides : {101, 202, 403, 1000, 4004}) {
    // cot x = 1/x - x/3 ...: the worst of the three cases is off by less than 2 (pi/n)^2.
    const double error = 2 * std::pow(pi / sides, 2);
    REQUIRE(prism_rectilinearity(sides, 1, 3) == Approx(cylinder_rectilinearity(1, 3)).margin(error));
    REQUIRE(prism_rectilinearity(sides, 1, 3, false) == Approx(cylinder_rectilinearity(1, 3, false)).margin(error));
  }
  REQUIRE(cylinder_rectilinearity(1, 1e9) == Approx(3 * pi / 4 - 2).margin(1e-8));
  REQUIRE(cylinder_rectilinearity(1, 1e-9) == Approx(1).margin(1e-8));
}

TEST_CASE("ellipsoids: area and limits", "[closed-forms]") {
  REQUIRE(ellipsoid_area(2, 2, 2) == Approx(16 * pi));
  REQUIRE(ellipsoid_area(1, 2, 3) == Approx(ellipsoid_area(3, 1, 2)).epsilon(1e-14));
  // Of revolution, in elementary functions.
  const double c = 3, e = std::sqrt(1 - 1 / (c * c));
  REQUIRE(ellipsoid_area(1, 1, c) == Approx(2 * pi * (1 + c / e * std::asin(e))).epsilon(1e-13));
  const double d = 0.4, f = std::sqrt(1 - d * d);
  REQUIRE(ellipsoid_area(1, 1, d) == Approx(2 * pi * (1 + d * d / f * std::atanh(f))).epsilon(1e-13));

  REQUIRE(ellipsoid_rectilinearity(1, 1, 1) == Approx(0).margin(1e-15));                // the sphere
  REQUIRE(ellipsoid_rectilinearity(1, 1, 1e5) == Approx(3 * pi / 4 - 2).margin(1e-4));  // a needle, like a cylinder
  REQUIRE(ellipsoid_rectilinearity(1, 1, 1e-5) == Approx(1).margin(1e-4));              // a disc
}

TEST_CASE("meshes of ellipsoids tend to the closed form like one over the faces", "[closed-forms]") {
  struct Axes {
    double a, b, c;
  };
  for (const Axes& x : {Axes{1, 1, 1}, {1, 1, 2}, {1, 1, 0.5}, {1, 0.75, 0.5}, {1, 1, 5}}) {
    const double expected = ellipsoid_rectilinearity(x.a, x.b, x.c);
    for (const int level : {2, 3, 4}) {
      std::string source = with("shape:ellipsoid?kind=octahedral&a=", x.a);
      source = with(with(source + "&b=", x.b) + "&c=", x.c) + "&rotate=random&subdivisions=" + std::to_string(level);
      const double faces = 8 * std::pow(4, level);
      REQUIRE(certified(source, 0.1 / faces) == Approx(expected).margin(20 / faces));
    }
  }
}

TEST_CASE("a cube with one face tilted", "[closed-forms]") {
  REQUIRE(tilted_top_rectilinearity(0) == 1);
  REQUIRE(tilted_top_rectilinearity(pi / 2) == Approx(1).margin(1e-15));
  for (const double tilt : {1e-9, 1e-6, 1e-3, 0.1, 0.5, pi / 4, 1.0, 1.5})
    require_certified(area_vectors(tilted_top_cube(tilt)), tilted_top_rectilinearity(tilt), 1e-10);
}
