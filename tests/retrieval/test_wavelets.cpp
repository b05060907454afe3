// Wavelets on the sphere by what defines them, and the extent in given directions.
#include <cmath>
#include <numbers>

#include "features/radial_extent.h"
#include "features/spherical_wavelets.h"
#include "rectilin/base/random.h"
#include "rectilin/mesh/source.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::retrieval;

namespace {

std::vector<double> random_function(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> values(n);
  for (double& v : values) v = random.uniform(-1, 1);
  return values;
}

}  // namespace

TEST_CASE("Wavelet coefficients give the function back, and keep its mean") {
  for (int level = 0; level <= 4; ++level) {
    const render::ViewSphere sphere(level);
    const SphericalWavelets wavelets(sphere);
    const std::vector<double> values = random_function(sphere.size(), 7);
    const std::vector<double> coefficients = wavelets.coefficients(values);
    const std::vector<double> back = wavelets.values(coefficients);
    double mean = 0, coarse = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      CHECK(back[k] == Approx(values[k]).margin(1e-12));
      mean += values[k] / static_cast<double>(values.size());
    }
    for (std::size_t k = 0; k < 6; ++k) coarse += coefficients[k] * std::sqrt(wavelets.areas()[k]);
    CHECK(coarse == Approx(mean).margin(1e-12));
  }
}

TEST_CASE("A constant has no differences, and the six means have its norm") {
  const render::ViewSphere sphere(3);
  const auto coefficients = SphericalWavelets(sphere).coefficients(std::vector<double>(sphere.size(), 3));
  double square = 0;
  for (std::size_t k = 0; k < 6; ++k) square += coefficients[k] * coefficients[k];
  CHECK(square == Approx(9));
  for (std::size_t k = 6; k < coefficients.size(); ++k) CHECK(std::abs(coefficients[k]) < 1e-14);
}

TEST_CASE("A bump at one vertex is seen as a difference there and by the vertices around it alone") {
  const render::ViewSphere sphere(2);  // 66 vertices, of which 18 ... 65 emerged last
  std::vector<double> values(sphere.size());
  values[40] = 1;
  const auto coefficients = SphericalWavelets(sphere).coefficients(values);
  CHECK(coefficients[40] == Approx(std::sqrt(1.0 / 66)));
  for (std::size_t k = 18; k < 66; ++k)
    if (k != 40) CHECK(coefficients[k] == 0);
}

TEST_CASE("Rotations of the cube permute the coefficients") {
  const render::ViewSphere sphere(3);
  const SphericalWavelets wavelets(sphere);
  const std::vector<double> values = random_function(sphere.size(), 8);
  const std::vector<double> coefficients = wavelets.coefficients(values);
  for (const auto& permutation : sphere.permutations()) {
    std::vector<double> turned(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) turned[k] = values[permutation[k]];
    const std::vector<double> of_turned = wavelets.coefficients(turned);
    for (std::size_t k = 0; k < values.size(); ++k)
      CHECK(of_turned[k] == Approx(coefficients[permutation[k]]).margin(1e-12));
  }
}

TEST_CASE("The extent in given directions is that of the grid") {
  const Mesh mesh = load_mesh("shape:lshape").mesh;
  constexpr int kGrid = 24;
  std::vector<Vector3> directions;
  for (int j = 0; j < kGrid; ++j)
    for (int k = 0; k < kGrid; ++k) {
      const double theta = std::numbers::pi * (j + 0.5) / kGrid, phi = 2 * std::numbers::pi * k / kGrid;
      directions.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  const std::vector<double> grid = radial_extent(mesh, kGrid, 2), own = radial_extent(mesh, directions);
  for (std::size_t i = 0; i < own.size(); ++i) CHECK(own[i] == Approx(grid[i]).margin(1e-12));
}
