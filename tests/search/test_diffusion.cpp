// Diffusion: against the linear system it solves, and where it differs from distances.
#include <Eigen/Dense>

#include "reciprocal.h"
#include "rectilin/base/random.h"
#include "rectilin/search/diffusion.h"
#include "support/catch.h"

using namespace rectilin;
using namespace rectilin::search;

namespace {

std::vector<float> distances_of(const std::vector<Eigen::Vector2d>& points) {
  std::vector<float> d;
  for (const auto& a : points)
    for (const auto& b : points) d.push_back(static_cast<float>((a - b).norm()));
  return d;
}

}  // namespace

TEST_CASE("the way along a curve counts, not the straight one") {
  // A half circle of points from (-1, 0) to (1, 0), and a far cluster that is nearer to its beginning than its end is.
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 40; ++i)
    points.emplace_back(-std::cos(3.14159265 * i / 40), 1.5 * std::sin(3.14159265 * i / 40));
  for (int i = 0; i < 10; ++i) points.emplace_back(-1.3 - 0.01 * i, -1.0 - 0.013 * (i % 3));
  const auto d = distances_of(points);
  const auto f = diffuse(d, points.size(), {.neighbours = 3, .spread = 0.99, .steps = 3000, .expand = 1});
  for (std::size_t i = 41; i < points.size(); ++i) {
    CHECK(d[i] < d[40]);
    CHECK(f[i] < f[40]);
  }
  for (std::size_t i = 1; i <= 40; ++i) CHECK(f[i] > 0);
}

TEST_CASE("many steps solve the linear system") {
  Random random(3);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 12; ++i) points.emplace_back(random.normal(), random.normal());
  const auto d = distances_of(points);
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd w(n, n);
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale(i) = 0;
    for (Eigen::Index j = 0; j < n; ++j) scale(i) = std::max(scale(i), static_cast<double>(d[i * n + j]));
  }
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      w(i, j) = i == j ? 0 : std::exp(-std::pow(d[i * n + j], 2) / (scale(i) * scale(j)));
  const Eigen::VectorXd root = w.rowwise().sum().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd s = root.asDiagonal() * w * root.asDiagonal();
  const Eigen::MatrixXd exact =
      root.asDiagonal() * (Eigen::MatrixXd::Identity(n, n) - 0.8 * s).inverse() * root.asDiagonal() * 0.2;
  for (const std::size_t expand : {1, 3}) {
    // With all others as neighbours the graph is complete.
    const auto f = diffuse(d, points.size(), {.neighbours = 11, .spread = 0.8, .steps = 400, .expand = expand});
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(n, n);  // of each and those nearest to it
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        Eigen::Index nearer = 0;
        for (Eigen::Index k = 0; k < n; ++k) nearer += d[i * n + k] < d[i * n + j];
        if (nearer < static_cast<Eigen::Index>(expand)) mean(i, j) = 1.0 / static_cast<double>(expand);
      }
    const Eigen::MatrixXd expected = mean * exact * mean.transpose() / (root(0) * root(0));
    for (Eigen::Index i = 0; i < n; ++i) CHECK(f[static_cast<std::size_t>(i)] == Approx(expected(0, i)).epsilon(1e-9));
  }
}

TEST_CASE("reciprocal neighbours of two clusters") {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 6; ++i) points.emplace_back(0.1 * i, 0.01 * i * i);
  for (int i = 0; i < 6; ++i) points.emplace_back(3 + 0.1 * i, 0.01 * i * i);
  const auto j = reciprocal_distances(distances_of(points), points.size(), {.neighbours = 5, .expand = 2});
  CHECK(j[0] == 0);
  for (std::size_t i = 1; i < 6; ++i) CHECK(j[i] < 0.8);
  for (std::size_t i = 6; i < 12; ++i) CHECK(j[i] == 1);
  // All shapes have the same neighbours, all of them at one distance: nothing tells them apart.
  for (const double d : reciprocal_distances(std::vector<float>(25, 0), 5, {.neighbours = 4, .expand = 5}))
    CHECK(d == Approx(0).margin(1e-12));
}

TEST_CASE("one shape alone, and shapes at one place") {
  CHECK(diffuse(std::vector<float>{0}, 1).size() == 1);
  CHECK(collection_ranking(std::vector<float>{0}, 1) == std::vector<double>{0});
  const auto f = diffuse(std::vector<float>(16, 0), 4);
  for (std::size_t i = 1; i < 4; ++i) CHECK(f[i] > 0);
}
