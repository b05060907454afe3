// Distances of bytes against plain loops; the groups behind the matching.
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "features/light_field.h"
#include "matching/byte_distance.h"
#include "rectilin/base/random.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/render/view_sphere.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::retrieval;

TEST_CASE("The least distance over permutations is exact on every instruction set") {
  Random random(2);
  for (const std::size_t views : {6u, 18u, 66u, 258u}) {
    const render::ViewSphere sphere = render::ViewSphere::of_size(views);
    std::vector<std::uint16_t> permutations;
    for (const auto& p : sphere.permutations()) permutations.insert(permutations.end(), p.begin(), p.end());
    std::vector<std::uint8_t> a(views * kRow), b(views * kRow);
    for (auto* bytes : {&a, &b})
      for (std::uint8_t& byte : *bytes) byte = static_cast<std::uint8_t>(random.below(256));
    std::uint32_t expected = std::numeric_limits<std::uint32_t>::max();
    for (std::size_t i = 0; i < 24; ++i) {
      std::uint32_t sum = 0;
      for (std::size_t k = 0; k < views; ++k)
        for (std::size_t c = 0; c < kRow; ++c)
          sum += static_cast<std::uint32_t>(
              std::abs(int{a[k * kRow + c]} - int{b[permutations[i * views + k] * kRow + c]}));
      expected = std::min(expected, sum);
    }
    for (const std::string& set : instruction_sets()) {
      const ScopedInstructionSet use(set);
      INFO(set);
      CHECK(least_distance(a.data(), b.data(), views, permutations) == expected);
    }
  }
}

TEST_CASE("Distances between all rows are exact on every instruction set") {
  Random random(3);
  std::vector<std::uint8_t> a(5 * 64), b(7 * 64);
  for (auto* bytes : {&a, &b})
    for (std::uint8_t& byte : *bytes) byte = static_cast<std::uint8_t>(random.below(256));
  for (const std::string& set : instruction_sets()) {
    const ScopedInstructionSet use(set);
    std::vector<std::uint32_t> out(35);
    row_distances(a.data(), 5, b.data(), 7, 64, out.data());
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 7; ++j) {
        std::uint32_t sum = 0;
        for (std::size_t c = 0; c < 64; ++c)
          sum += static_cast<std::uint32_t>(std::abs(int{a[64 * i + c]} - int{b[64 * j + c]}));
        CHECK(out[7 * i + j] == sum);
      }
  }
}

TEST_CASE("The rotations of the dodecahedron are a group of 60 on its ten axes") {
  const auto& rotations = light_field_rotations();
  REQUIRE(rotations.size() == 60);
  const std::set<std::array<std::uint8_t, kCameras>> all(rotations.begin(), rotations.end());
  CHECK(all.size() == 60);
  for (const auto& p : rotations)
    for (const auto& q : rotations) {
      std::array<std::uint8_t, kCameras> product;
      for (std::size_t c = 0; c < kCameras; ++c) product[c] = p[q[c]];
      REQUIRE(all.contains(product));
    }
}

TEST_CASE("The cameras are those of the light field descriptor's program") {
  const char* data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) {
    WARN("skipped: RECTILIN_DATA is not set");
    return;
  }
  for (std::size_t f = 0; f < kFields; ++f) {
    std::ifstream in(std::string(data) + "/lfd-ntu/12_" + std::to_string(f) + ".obj");
    std::size_t c = 0;
    for (std::string line; c < kCameras && std::getline(in, line);) {
      std::istringstream words(line);
      std::string v;
      Vector3 p;
      if (!(words >> v >> p.x() >> p.y() >> p.z()) || v != "v") continue;
      CHECK((p.normalized() - light_field_directions()[f * kCameras + c]).norm() < 1e-5);
      ++c;
    }
    CHECK(c == kCameras);
  }
}
