// Moments, Fourier coefficients, spherical harmonics and reach against their definitions, written out plainly here.
#include <cmath>
#include <complex>
#include <numbers>

#include "features/fourier.h"
#include "features/radial_extent.h"
#include "features/spherical_harmonics.h"
#include "features/zernike.h"
#include "rectilin/base/random.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/shapes.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::retrieval;

namespace {

/// R_nm by the recurrence of Prata and Rusch (1989), not by the sum that the library uses.
double radial(int n, int m, double rho) {
  if (n < m || n < 0 || m < 0) return 0;
  if (n == m) return std::pow(rho, n);
  const double first = 2 * rho * n / (n + m) * radial(n - 1, std::abs(m - 1), rho);
  return first - static_cast<double>(n - m) / (n + m) * radial(n - 2, m, rho);
}

}  // namespace

TEST_CASE("Zernike moments of a random picture are the sums they are defined by") {
  Random random(1);
  Picture picture(41, 53);
  for (Eigen::Index i = 0; i < picture.size(); ++i) picture.data()[i] = static_cast<float>(random.uniform());
  const Disk disk{24.3, 21.7, 40};
  const auto moments = ZernikeMoments::instance()(picture, disk);
  std::size_t at = 0;
  for (int n = 0; n <= 10; ++n)
    for (int m = n % 2; m <= n; m += 2, ++at) {
      std::complex<double> sum = 0;
      for (Eigen::Index row = 0; row < picture.rows(); ++row)
        for (Eigen::Index column = 0; column < picture.cols(); ++column) {
          const double x = (static_cast<double>(column) - disk.x) / disk.radius;
          const double y = (disk.y - static_cast<double>(row)) / disk.radius;
          sum += static_cast<double>(picture(row, column)) *
                 std::polar(radial(n, m, std::hypot(x, y)), -m * std::atan2(y, x));
        }
      sum *= (n + 1) / std::numbers::pi / (disk.radius * disk.radius);
      INFO("n " << n << " m " << m);
      CHECK(std::abs(moments[at] - sum) < 2e-5);
    }
  CHECK(at == ZernikeMoments::kCount);
}

TEST_CASE("A full disk has A_00 = 1 and next to nothing else") {
  Picture picture(201, 201);
  for (int y = 0; y < 201; ++y)
    for (int x = 0; x < 201; ++x) picture(y, x) = std::hypot(x - 100, y - 100) <= 100.5 ? 1.f : 0.f;
  const auto moments = ZernikeMoments::instance()(picture, {100, 100, 100.5});
  CHECK(std::abs(moments[0]) == Approx(1).epsilon(0.002));
  for (std::size_t k = 1; k < moments.size(); ++k) CHECK(std::abs(moments[k]) < 0.02);
}

TEST_CASE("Fourier descriptors of a wave are its amplitude, wherever it begins and whichever way it goes") {
  std::vector<double> wave;
  for (int i = 0; i < 90; ++i) wave.push_back(5 + 2 * std::cos(2 * std::numbers::pi * 3 * (i + 11) / 90));
  const auto c = fourier_descriptors(wave, 10);
  for (int k = 1; k <= 10; ++k) CHECK(c[static_cast<std::size_t>(k - 1)] == Approx(k == 3 ? 0.2 : 0).margin(1e-12));
  const std::vector<double> back(wave.rbegin(), wave.rend());
  CHECK(fourier_descriptors(back, 10)[2] == Approx(0.2));
  CHECK(fourier_descriptors(std::vector<double>{0, 0}, 3) == std::vector<double>{0, 0, 0});
}

TEST_CASE("Spherical harmonics of known functions") {
  constexpr int kGrid = 64;
  std::vector<double> one(kGrid * kGrid, 1), z, x;
  for (int j = 0; j < kGrid; ++j)
    for (int k = 0; k < kGrid; ++k) {
      const double theta = std::numbers::pi * (j + 0.5) / kGrid, phi = 2 * std::numbers::pi * k / kGrid;
      z.push_back(std::cos(theta));
      x.push_back(std::sin(theta) * std::cos(phi));
    }
  const HarmonicTransform transform(kGrid, 16);
  CHECK(transform.size() == 136);
  const auto of_one = transform.magnitudes(one), of_z = transform.magnitudes(z), of_x = transform.magnitudes(x);
  for (std::size_t i = 0; i < 136; ++i) {
    CHECK(of_one[i] == Approx(i == 0 ? std::sqrt(4 * std::numbers::pi) : 0).margin(1e-10));
    CHECK(of_z[i] == Approx(i == 1 ? std::sqrt(4 * std::numbers::pi / 3) : 0).margin(1e-10));
    CHECK(of_x[i] == Approx(i == 2 ? std::sqrt(2 * std::numbers::pi / 3) : 0).margin(1e-10));
  }
}

TEST_CASE("The reach of a cube is known in every direction, about every pole") {
  Mesh cube = make_shape(Spec::parse("box"));
  Vector3 middle = Vector3::Zero();
  for (const Vector3& v : cube.vertices) middle += v / static_cast<double>(cube.vertices.size());
  double half = 0;
  for (Vector3& v : cube.vertices) {
    v -= middle;
    half = std::max(half, v.lpNorm<Eigen::Infinity>());
  }
  for (int pole = 0; pole < 3; ++pole) {
    const auto reach = radial_extent(cube, 32, pole);
    for (int j = 0; j < 32; ++j)
      for (int k = 0; k < 32; ++k) {
        const double theta = std::numbers::pi * (j + 0.5) / 32, phi = 2 * std::numbers::pi * k / 32;
        const double largest = std::max({std::abs(std::cos(theta)), std::abs(std::sin(theta) * std::cos(phi)),
                                         std::abs(std::sin(theta) * std::sin(phi))});
        CHECK(reach[static_cast<std::size_t>(32 * j + k)] == Approx(half / largest));
      }
  }
}

TEST_CASE("A soup far from the origin is reached as a search over all triangles says") {
  Random random(5);
  Mesh soup;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const Vector3 at(random.normal(), random.normal(), random.normal());
    for (int c = 0; c < 3; ++c)
      soup.vertices.push_back(at + 0.7 * Vector3(random.normal(), random.normal(), random.normal()));
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const auto reach = radial_extent(soup, 16, 2);
  for (int j = 0; j < 16; ++j)
    for (int k = 0; k < 16; ++k) {
      const double theta = std::numbers::pi * (j + 0.5) / 16, phi = 2 * std::numbers::pi * k / 16;
      const Vector3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      double farthest = 0;
      for (const Triangle& t : soup.triangles) {  // d t = a + u (b-a) + v (c-a)
        Eigen::Matrix3d m;
        const Vector3 a = soup.vertices[t[0]];
        m << d, a - soup.vertices[t[1]], a - soup.vertices[t[2]];
        const Vector3 s = m.inverse() * a;
        if (s[1] >= 0 && s[2] >= 0 && s[1] + s[2] <= 1) farthest = std::max(farthest, s[0]);
      }
      CHECK(reach[static_cast<std::size_t>(16 * j + k)] == Approx(farthest));
    }
}
