// The flat sum against exact arithmetic's stand-in, long double, and against what h must be as a
// function.
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "rectilin/measure/flat_sum.h"
#include "support/catch.h"
#include "support/sum_fixtures.h"

using namespace rectilin;

namespace {

/// Lengths from 1e-40 to 1.
Directions spread(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-40, 0);
  Directions result = gaussian(size, seed + 1);
  for (Vector3& v : result) v *= std::pow(10.0, exponent(random)) / v.norm();
  return result;
}

/// Random directions, and those at which slopes are extreme or the sum has kinks.
Directions flat_test_directions(const Directions& vectors) {
  Directions u = gaussian(13, 99);
  u.insert(u.end(), {Vector3::UnitX(),
                     -Vector3::UnitY(),
                     Vector3::UnitZ(),
                     {0.6, 0.8, 1e-17},
                     {1e-9, -1e-30, -1},
                     {1, 1, -0.0},
                     {0, 0, 1e-200},
                     {3e100, 4e100, 0}});
  if (!vectors.empty()) u.push_back(vectors[0].unitOrthogonal());
  return u;
}

std::vector<double> values(const FlatSum& sum, const Directions& u) {
  std::vector<double> h(u.size());
  sum.values(u, h);
  return h;
}

Directions cuts(const FlatSum& sum, const Directions& u) {
  Directions g(u.size());
  sum.cuts(u, g);
  return g;
}

template <class Check>
void on_every_target(const Check& check) {
  for (const std::string& name : instruction_sets()) {
    CAPTURE(name);
    ScopedInstructionSet target(name);
    check();
  }
}

}  // namespace

TEST_CASE("flat sums of every size agree with long double", "[flat_sum]") {
  std::vector<std::size_t> sizes(34);
  for (std::size_t n = 0; n < sizes.size(); ++n) sizes[n] = n;
  sizes.insert(sizes.end(), {1000, 2047, 2049, 4096, 32768, 32775, 100000});
  for (const std::size_t size : sizes) {
    CAPTURE(size);
    for (const Directions& vectors : {gaussian(size, 1), spread(size, 2)}) {
      const AreaVectors area = make_vectors(vectors);
      const Directions u = flat_test_directions(vectors);
      std::vector<double> exact;
      for (const Vector3& w : u) exact.push_back(exact_value(vectors, w));
      on_every_target([&] {
        const std::vector<double> twofold = values(FlatSum(area), u);
        const std::vector<double> single = values(FlatSum(area, Precision::kSingle), u);
        for (std::size_t k = 0; k < u.size(); ++k) {
          CAPTURE(u[k].transpose());
          const double unit = u[k].stableNorm() * area.total;
          // The documented bounds; 1e-12 is what the objective's certificate counts on.
          CHECK(std::abs(twofold[k] - exact[k]) <= 1e-12 * unit);
          CHECK(std::abs(single[k] - exact[k]) <= FlatSum::relative_error_bound(Precision::kSingle) * unit);
        }
      });
    }
  }
  CHECK(FlatSum::relative_error_bound(Precision::kDouble) < 1e-12);
}

TEST_CASE("single precision is good to six digits on ordinary meshes", "[flat_sum]") {
  const Directions vectors = gaussian(100000, 3), u = gaussian(20, 4);
  const AreaVectors area = make_vectors(vectors);
  const std::vector<double> h = values(FlatSum(area, Precision::kSingle), u);
  // Rounding errors of single precision are random here: far below the worst case.
  for (std::size_t k = 0; k < u.size(); ++k) {
    CHECK(h[k] == Approx(exact_value(vectors, u[k])).epsilon(2e-6));
  }
}

TEST_CASE("h is even, homogeneous and convex", "[flat_sum]") {
  const AreaVectors area = make_vectors(gaussian(777, 5));
  const FlatSum sum(area);
  const Directions a = gaussian(50, 6), b = gaussian(50, 7);
  Directions negative, twice, middle;
  for (std::size_t k = 0; k < a.size(); ++k) {
    negative.push_back(-a[k]);
    twice.push_back(2 * a[k]);
    middle.push_back((a[k] + b[k]) / 2);
  }
  const auto ha = values(sum, a), hb = values(sum, b), hm = values(sum, middle);
  CHECK(values(sum, negative) == ha);
  const auto h2 = values(sum, twice);
  for (std::size_t k = 0; k < a.size(); ++k) {
    CHECK(h2[k] == 2 * ha[k]);  // a power of two changes no digit
    CHECK(hm[k] <= (ha[k] + hb[k]) / 2 + 1e-12 * area.total * (a[k].stableNorm() + b[k].stableNorm()));
  }
}

TEST_CASE("known sums", "[flat_sum]") {
  const double third = 1.0 / 3;
  const AreaVectors cube = make_vectors({{third, 0, 0}, {0, third, 0}, {0, 0, third}});
  const AreaVectors nothing = make_vectors({});
  const AreaVectors zeros = make_vectors(Directions(100, Vector3::Zero()));
  on_every_target([&] {
    const Directions u = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0, 0, 0}};
    CHECK(values(FlatSum(cube), u)[0] == Approx(third).epsilon(1e-15));
    CHECK(values(FlatSum(cube), u)[3] == Approx(1).epsilon(1e-15));
    CHECK(values(FlatSum(cube), u)[4] == 0);
    for (const double h : values(FlatSum(nothing), u)) CHECK(h == 0);
    for (const double h : values(FlatSum(zeros), u)) CHECK(h == 0);
    for (const Vector3& g : cuts(FlatSum(zeros), u)) CHECK(g == Vector3::Zero());
  });
}

TEST_CASE("parallel faces, seen edge on, sum to nothing", "[flat_sum]") {
  const Vector3 v = Vector3(1, 2, 3).normalized();
  const AreaVectors area = make_vectors(Directions(5000, v));
  const Vector3 across = v.unitOrthogonal(), along = v;
  on_every_target([&] {
    const auto h = values(FlatSum(area), {across, along});
    CHECK(h[0] <= 1e-12 * area.total);
    CHECK(h[1] == Approx(5000).epsilon(1e-13));
  });
}

TEST_CASE("cuts are minorants of h, tight where they were made", "[flat_sum]") {
  for (const std::size_t size : {1u, 7u, 33u, 1000u, 40001u}) {
    CAPTURE(size);
    for (const Directions& vectors : {gaussian(size, 8), spread(size, 9)}) {
      const AreaVectors area = make_vectors(vectors);
      const Directions u = flat_test_directions(vectors);
      on_every_target([&] {
        for (const Precision precision : {Precision::kSingle, Precision::kDouble}) {
          const FlatSum sum(area, precision);
          const double bound = 2 * FlatSum::relative_error_bound(precision) * area.total;
          const auto h = values(sum, u);
          const auto g = cuts(sum, u);
          for (std::size_t k = 0; k < u.size(); ++k) {
            CHECK(std::abs(g[k].dot(u[k]) - h[k]) <= bound * u[k].stableNorm());
            for (std::size_t j = 0; j < u.size(); ++j) {
              CHECK(g[k].dot(u[j]) <= h[j] + bound * u[j].stableNorm());
            }
          }
        }
      });
    }
  }
}

TEST_CASE("bits depend neither on threads nor on the other directions of a call", "[flat_sum]") {
  // Enough work for tasks over faces in the first case, over directions in the second.
  for (const auto& [size, count] : {std::pair{200003, 20}, std::pair{9001, 500}}) {
    const AreaVectors area = make_vectors(gaussian(static_cast<std::size_t>(size), 10));
    const Directions u = gaussian(static_cast<std::size_t>(count), 11);
    for (const Precision precision : {Precision::kSingle, Precision::kDouble}) {
      const FlatSum sum(area, precision);
      const auto h = with_threads(1, [&] { return values(sum, u); });
      const auto g = with_threads(1, [&] { return cuts(sum, u); });
      for (const int threads : {2, 8}) {
        CHECK(with_threads(threads, [&] { return values(sum, u); }) == h);
        CHECK(with_threads(threads, [&] { return cuts(sum, u); }) == g);
      }
      for (std::size_t k = 0; k < u.size(); k += 7) {
        CHECK(values(sum, {u[k]})[0] == h[k]);
        CHECK(cuts(sum, {u[k]})[0] == g[k]);
      }
    }
  }
}

TEST_CASE("a target must exist", "[flat_sum]") {
  CHECK_FALSE(instruction_sets().empty());
  CHECK_THROWS_AS(ScopedInstructionSet("abacus"), std::invalid_argument);
}
