#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "rectilin/optim/chart.h"
#include "rectilin/optim/parameters.h"

using namespace rectilin;

namespace {

/// Does the chart reach the frame of r?
bool reaches(const Chart& chart, const Rotation& r) {
  const Eigen::Vector3d x = chart.coordinates(r);
  REQUIRE((x.array() >= chart.lower().array()).all());
  REQUIRE((x.array() <= chart.upper().array()).all());
  return frame_angle(chart.rotation(x), r) < 1e-6;
}

}  // namespace

TEST_CASE("the covering charts reach every frame", "[chart]") {
  Random random(1);
  for (const Chart* chart : {&covering_chart(), &zone_chart()}) {
    REQUIRE(chart->covers());
    for (int i = 0; i < 5000; ++i) REQUIRE(reaches(*chart, random_rotation(random)));
    for (const Rotation& d : frame_symmetries()) REQUIRE(reaches(*chart, d));
  }
}

TEST_CASE("the paper's box reaches three quarters of all frames", "[chart]") {
  REQUIRE_FALSE(paper_chart().covers());
  Random random(2);
  const int n = 20000;
  int reached = 0;
  for (int i = 0; i < n; ++i) reached += reaches(paper_chart(), random_rotation(random));
  // Four standard deviations of a binomial proportion.
  REQUIRE(reached / static_cast<double>(n) == Approx(0.75).margin(4 * std::sqrt(0.75 * 0.25 / n)));
}

TEST_CASE("on the Euler charts the third axis does not depend on gamma, bit for bit", "[chart]") {
  for (const Chart* chart : {&paper_chart(), &covering_chart()}) {
    const Rotation a = chart->rotation({0.7, 0.4, 0.1}), b = chart->rotation({0.7, 0.4, 1.5});
    REQUIRE(a.axis(2) == b.axis(2));
    REQUIRE(a.axis(0) != b.axis(0));
  }
}

TEST_CASE("the zone's cube contains the zone", "[chart]") {
  REQUIRE(kZoneHalfEdge >= std::sqrt(2.0L) - 1);
  REQUIRE(kZoneHalfEdge < std::sqrt(2.0L) - 1 + 1e-15L);
}

TEST_CASE("charts are found by name", "[chart]") {
  REQUIRE(&chart_by_name("paper") == &paper_chart());
  REQUIRE(&chart_by_name("zone") == &zone_chart());
  REQUIRE_THROWS_AS(chart_by_name("sphere"), ParameterError);
}
