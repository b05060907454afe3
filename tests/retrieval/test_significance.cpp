// Paired differences: exact small cases, and how often luck is called a difference.
#include <vector>

#include "rectilin/base/random.h"
#include "rectilin/retrieval/significance.h"
#include "support/catch.h"

using namespace rectilin::retrieval;

TEST_CASE("Equal lists do not differ") {
  const std::vector<double> a{1, 2, 3};
  const PairedDifference d = paired_difference(a, a, std::vector<std::size_t>{0, 1, 2});
  CHECK(d.mean == 0);
  CHECK(d.p == 1);
  CHECK(d.low == 0);
  CHECK(d.high == 0);
}

TEST_CASE("Few classes are tested exactly: all of one sign is two patterns of 2^n") {
  const std::vector<double> a{1, 1, 2, 3, 1, 5}, b(6, 0.0);
  const std::vector<std::size_t> apart{0, 1, 2, 3, 4, 5}, pairs{0, 0, 1, 1, 2, 2};
  CHECK(paired_difference(a, b, apart).p == Approx(2.0 / 64));
  CHECK(paired_difference(a, b, pairs).p == Approx(2.0 / 8));  // queries of one class are one piece of evidence
  CHECK(paired_difference(a, b, pairs).mean == Approx(13.0 / 6));
  CHECK(paired_difference(b, a, pairs).mean == Approx(-13.0 / 6));
}

TEST_CASE("Luck is called a difference as often as promised, even if classes move together") {
  rectilin::Random random(7);
  int rejected = 0, covered = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> a, b;
    std::vector<std::size_t> group;
    for (std::size_t c = 0; c < 30; ++c) {
      const double together = random.normal();
      for (int i = 0; i < 5; ++i) {
        a.push_back(together + 0.3 * random.normal());
        b.push_back(0);
        group.push_back(c);
      }
    }
    const PairedDifference d = paired_difference(a, b, group);
    rejected += d.p <= 0.05;
    covered += d.low <= 0 && 0 <= d.high;
  }
  CHECK(rejected <= 20);  // 10 expected, standard deviation 3
  CHECK(rejected >= 2);
  CHECK(covered >= 175);  // 190 expected of an exact interval; the bootstrap's are a little short
}
