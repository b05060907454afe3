#include <algorithm>
#include <set>

#include "rectilin/base/rotation.h"
#include "rectilin/render/camera.h"
#include "rectilin/render/view_sphere.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::render;

TEST_CASE("Spheres of views have the sizes of the paper's eqs. 29 to 32", "[views]") {
  std::size_t vertices = 6, faces = 8, edges = 12;
  for (int level = 0; level <= 4; ++level) {
    const ViewSphere sphere(level);
    CHECK(sphere.size() == vertices);
    CHECK(sphere.faces().size() == faces);
    CHECK(sphere.edges().size() == vertices - 6);
    CHECK(ViewSphere::of_size(vertices).level() == level);
    vertices += edges, faces *= 4, edges = faces * 3 / 2;
  }
  CHECK_THROWS_AS(ViewSphere(-1), std::invalid_argument);
  CHECK_THROWS_AS(ViewSphere(7), std::invalid_argument);
  CHECK_THROWS_AS(ViewSphere::of_size(20), std::invalid_argument);
}

TEST_CASE("Directions are distinct unit vectors; a finer sphere begins with the coarser", "[views]") {
  const ViewSphere fine(3);
  for (int level = 0; level < 3; ++level) {
    const ViewSphere coarse(level);
    CHECK(std::equal(coarse.directions().begin(), coarse.directions().end(), fine.directions().begin()));
  }
  for (std::size_t k = 0; k < fine.size(); ++k) {
    CHECK(std::abs(fine.directions()[k].norm() - 1) < 1e-15);
    for (std::size_t m = 0; m < k; ++m) CHECK(fine.directions()[k].dot(fine.directions()[m]) < 0.995);
    if (k >= 6) {
      const auto [a, b] = fine.edges()[k - 6];
      CHECK((fine.directions()[a] + fine.directions()[b]).normalized().isApprox(fine.directions()[k], 1e-15));
    }
  }
}

TEST_CASE("Faces close the sphere and look outward", "[views]") {
  for (int level = 0; level <= 3; ++level) {
    const ViewSphere sphere(level);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    double volume = 0;
    for (const auto& [a, b, c] : sphere.faces()) {
      const auto d = sphere.directions();
      CHECK(d[a].dot(d[b].cross(d[c])) > 0);
      volume += d[a].dot(d[b].cross(d[c])) / 6;
      for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) CHECK(edges.emplace(u, v).second);
    }
    for (const auto& [u, v] : edges) CHECK(edges.count({v, u}) == 1);
    CHECK(volume < 4.18879);
    CHECK(volume > std::array{1.3, 2.9, 3.7, 4.0}[static_cast<std::size_t>(level)]);
  }
}

TEST_CASE("The cube's rotations permute the directions, bit for bit", "[views]") {
  for (int level = 0; level <= 3; ++level) {
    const ViewSphere sphere(level);
    REQUIRE(sphere.permutations().size() == 24);
    std::set<std::vector<std::uint32_t>> distinct;
    for (std::size_t i = 0; i < 24; ++i) {
      const auto& p = sphere.permutations()[i];
      const Eigen::Matrix3d& d = frame_symmetries()[i].matrix();
      bool exact = p.size() == sphere.size();
      for (std::size_t k = 0; k < p.size(); ++k) exact &= d * sphere.directions()[p[k]] == sphere.directions()[k];
      CHECK(exact);
      distinct.insert(p);
    }
    CHECK(distinct.size() == 24);
    for (std::size_t k = 0; k < sphere.size(); ++k)
      CHECK(sphere.directions()[sphere.opposite()[k]] == -sphere.directions()[k]);
  }
}

TEST_CASE("On the octahedron the permutations are the paper's Table 1", "[views]") {
  const std::set<std::vector<std::uint32_t>> table = {
      {0, 1, 2, 3, 4, 5}, {0, 1, 4, 5, 3, 2}, {0, 1, 3, 2, 5, 4}, {0, 1, 5, 4, 2, 3}, {1, 0, 3, 2, 4, 5},
      {1, 0, 4, 5, 2, 3}, {1, 0, 2, 3, 5, 4}, {1, 0, 5, 4, 3, 2}, {4, 5, 2, 3, 1, 0}, {4, 5, 1, 0, 3, 2},
      {4, 5, 3, 2, 0, 1}, {4, 5, 0, 1, 2, 3}, {5, 4, 2, 3, 0, 1}, {5, 4, 0, 1, 3, 2}, {5, 4, 3, 2, 1, 0},
      {5, 4, 1, 0, 2, 3}, {2, 3, 1, 0, 4, 5}, {2, 3, 4, 5, 0, 1}, {2, 3, 0, 1, 5, 4}, {2, 3, 5, 4, 1, 0},
      {3, 2, 0, 1, 4, 5}, {3, 2, 4, 5, 1, 0}, {3, 2, 1, 0, 5, 4}, {3, 2, 5, 4, 0, 1}};
  const ViewSphere sphere(0);
  CHECK(std::set(sphere.permutations().begin(), sphere.permutations().end()) == table);
}

TEST_CASE("Frames are rotations that look where asked, opposites mirrored", "[views]") {
  const ViewSphere sphere(3);
  for (const Vector3& d : sphere.directions())
    for (const Vector3& up : {Vector3(0, 1, 0), Vector3(0, 0, 1), Vector3(1, 2, 3)}) {
      const Rotation frame = frame_towards(d, up), behind = frame_towards(-d, up);
      CHECK((frame.matrix() * frame.matrix().transpose()).isIdentity(1e-14));
      CHECK(frame.matrix().determinant() == Approx(1));
      CHECK(frame.axis(2).isApprox(d, 1e-15));
      CHECK(frame.axis(1).dot(up) > -1e-14);
      CHECK(behind.axis(0) == -frame.axis(0));
      CHECK(behind.axis(1) == frame.axis(1));
      CHECK(behind.axis(2) == -frame.axis(2));
    }
}
