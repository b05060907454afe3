#include <algorithm>
#include <cmath>
#include <numbers>

#include "rectilin/base/parameters.h"
#include "rectilin/optim/domain.h"
#include "support/catch.h"

using namespace rectilin;

namespace {

/// Does the domain reach the frame of r?
bool reaches(const Domain& domain, const Rotation& r) {
  const Eigen::Vector3d x = domain.coordinates(r);
  REQUIRE((x.array() >= domain.lower().array()).all());
  REQUIRE((x.array() <= domain.upper().array()).all());
  return frame_angle(domain.rotation(x), r) < 1e-6;
}

}  // namespace

TEST_CASE("the covering domains reach every frame", "[domain]") {
  Random random(1);
  for (const Domain* domain : {&covering_domain(), &zone_domain()}) {
    REQUIRE(domain->covers());
    for (int i = 0; i < 5000; ++i) REQUIRE(reaches(*domain, random_rotation(random)));
    for (const Rotation& d : frame_symmetries()) REQUIRE(reaches(*domain, d));
  }
}

TEST_CASE("the paper's box reaches three quarters of all frames", "[domain]") {
  REQUIRE_FALSE(paper_domain().covers());
  Random random(2);
  const int n = 20000;
  int reached = 0;
  for (int i = 0; i < n; ++i) reached += reaches(paper_domain(), random_rotation(random));
  // Four standard deviations of a binomial proportion.
  REQUIRE(reached / static_cast<double>(n) == Approx(0.75).margin(4 * std::sqrt(0.75 * 0.25 / n)));
}

TEST_CASE("on the Euler domains the third axis does not depend on gamma, bit for bit", "[domain]") {
  for (const Domain* domain : {&paper_domain(), &covering_domain()}) {
    const Rotation a = domain->rotation({0.7, 0.4, 0.1}), b = domain->rotation({0.7, 0.4, 1.5});
    REQUIRE(a.axis(2) == b.axis(2));
    REQUIRE(a.axis(0) != b.axis(0));
  }
}

TEST_CASE("the zone's cube contains the zone", "[domain]") {
  REQUIRE(kZoneHalfEdge >= std::sqrt(2.0L) - 1);
  REQUIRE(kZoneHalfEdge < std::sqrt(2.0L) - 1 + 1e-15L);
}

TEST_CASE("domains are found by name", "[domain]") {
  REQUIRE(&domain_by_name("paper") == &paper_domain());
  REQUIRE(&domain_by_name("zone") == &zone_domain());
  REQUIRE_THROWS_AS(domain_by_name("sphere"), ParameterError);
}
