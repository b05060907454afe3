// Statistics against values known in closed form or from tables.
#include <cmath>
#include <limits>

#include "rectilin/laboratory/statistics.h"
#include "support/catch.h"

namespace rectilin::laboratory {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-12;  // a few operations on numbers near 1

TEST_CASE("a power law's exponent is found whatever its factor") {
  const std::vector<double> x = {1, 10, 50, 2000};
  std::vector<double> y;
  for (const double size : x) y.push_back(7 * std::pow(size, -1.5));
  CHECK(power_law_exponent(x, y) == Approx(-1.5).margin(1e-12));
  const std::vector<double> one = {3}, two = {3, 3};
  CHECK(std::isnan(power_law_exponent(one, one)));
  CHECK(std::isnan(power_law_exponent(two, std::vector<double>{1, 2})));
}

TEST_CASE("quantiles interpolate between order statistics") {
  CHECK(median({5, 1, 3, 2, 4}) == 3);
  CHECK(median({4, 1, 3, 2}) == Approx(2.5).margin(kRounding));
  CHECK(quantile({5, 1, 3, 2, 4}, 0.25) == 2);
  CHECK(quantile({5, 1, 3, 2, 4}, 0.1) == Approx(1.4).margin(kRounding));
  CHECK(quantile({5, 1, 3, 2, 4}, 0) == 1);
  CHECK(quantile({5, 1, 3, 2, 4}, 1) == 5);
  CHECK(quantile({7}, 0.9) == 7);
  CHECK(median({1, kInfinity, kInfinity}) == kInfinity);
  CHECK(median({kInfinity, kInfinity}) == kInfinity);
}

TEST_CASE("equal values share their ranks") {
  CHECK(ranks(std::vector<double>{3, 1, 3, 2}) == std::vector<double>{3.5, 1, 3.5, 2});
  CHECK(ranks(std::vector<double>{kInfinity, kInfinity, 0}) == std::vector<double>{2.5, 2.5, 1});
}

TEST_CASE("the expected running time counts the failures") {
  RunningTime time;
  CHECK(std::isnan(time.success_rate()));
  time.add(kInfinity, 100);
  CHECK(time.expected() == kInfinity);
  CHECK(time.success_rate() == 0);
  time.add(40, 1000);
  time.add(60, 1000);
  CHECK(time.expected() == Approx(100).margin(kRounding));
  CHECK(time.success_rate() == Approx(2.0 / 3).margin(kRounding));
  // Mean time of a success, and for each success (1 - p) / p failures before it (Auger and Hansen 2005).
  const double p = time.success_rate();
  CHECK(time.expected() == Approx(50 + (1 - p) / p * 100).margin(kRounding));
}

TEST_CASE("the rank-sum test is exact for small samples") {
  // Of the 20 ways to choose 3 ranks of 6 one gives U = 0.
  const RankSum apart = rank_sum(std::vector<double>{1, 2, 3}, std::vector<double>{4, 5, 6});
  CHECK(apart.u == 0);
  CHECK(apart.p == Approx(2.0 / 20).margin(kRounding));
  CHECK(apart.superiority == 1);

  // Tables give U = 2 as the critical value for 5 and 5 at 5 %: 1 + 1 + 2 arrangements of 252 have U <= 2.
  const std::vector<double> a = {1, 2, 3, 4, 7}, b = {5, 6, 8, 9, 10};
  CHECK(rank_sum(a, b).u == 2);
  CHECK(rank_sum(a, b).p == Approx(2 * 4.0 / 252).margin(kRounding));
  const std::vector<double> c = {1, 2, 3, 5, 7}, d = {4, 6, 8, 9, 10};
  CHECK(rank_sum(c, d).p == Approx(2 * 7.0 / 252).margin(kRounding));

  // One value among n: U is uniform on 0..n.
  CHECK(rank_sum(std::vector<double>{0}, std::vector<double>{1, 2, 3, 4}).p == Approx(2.0 / 5).margin(kRounding));
}

TEST_CASE("the rank-sum test is symmetric") {
  const std::vector<double> a = {0.3, 1.7, 2.2, 9.1}, b = {0.1, 0.2, 1.0, 5.0, 6.0, 7.0};
  CHECK(rank_sum(a, b).p == Approx(rank_sum(b, a).p).margin(kRounding));
  CHECK(rank_sum(a, b).superiority + rank_sum(b, a).superiority == Approx(1).margin(kRounding));
  CHECK(rank_sum(a, b).u + rank_sum(b, a).u == 24);
}

TEST_CASE("the rank-sum test corrects for ties") {
  // Ranks 2, 5.5, 8 for 1, 2, 3; U = 5, variance 16/12 (9 - (24 + 60)/56) = 10, z = 2.5 / sqrt(10).
  const RankSum tied = rank_sum(std::vector<double>{1, 1, 2, 2}, std::vector<double>{1, 2, 2, 3});
  CHECK(tied.u == 5);
  CHECK(tied.p == Approx(std::erfc(2.5 / std::sqrt(20.0))).margin(kRounding));
  const RankSum equal = rank_sum(std::vector<double>{1, 1}, std::vector<double>{1, 1, 1});
  CHECK(equal.p == 1);
  CHECK(equal.superiority == 0.5);
  CHECK(rank_sum(std::vector<double>{kInfinity, kInfinity}, std::vector<double>{kInfinity}).p == 1);
}

TEST_CASE("the exact rank-sum test is near the normal approximation for large samples") {
  constexpr int kSize = 25;
  std::vector<double> a, b;
  for (int i = 0; i < kSize; ++i) a.push_back(i), b.push_back(i + 5.5);
  const RankSum test = rank_sum(a, b);
  const double pairs = kSize * kSize, deviation = std::sqrt(pairs * (2 * kSize + 1) / 12);
  const double z = (pairs / 2 - test.u - 0.5) / deviation;
  CHECK(test.p == Approx(std::erfc(z / std::sqrt(2.0))).epsilon(0.1));  // what the approximation is worth in this tail
}

TEST_CASE("Holm's correction") {
  const std::vector<double> corrected = holm(std::vector<double>{0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected = {0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(corrected[i] == Approx(expected[i]).margin(kRounding));
  CHECK(holm(std::vector<double>{0.7, 0.9}) == std::vector<double>{1, 1});
  CHECK(holm(std::vector<double>{}).empty());
}

}  // namespace
}  // namespace rectilin::laboratory
