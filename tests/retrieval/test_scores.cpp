// The measures against lists worked out by hand.
#include <cmath>

#include "rectilin/base/random.h"
#include "rectilin/retrieval/scores.h"
#include "support/catch.h"

using namespace rectilin::retrieval;

namespace {

/// Six models: class a has 0, 1, 2, class b has 3, 4, class c has 5; a tree with an empty root.
Classification six() {
  return parse_classification("PSB 1\n4 6\nroot 0 0\na root 3 0 1 2\nb root 2 3 4\nc 0 1 5\n", "six");
}

DistanceMatrix rows(const std::vector<std::vector<float>>& values) {
  DistanceMatrix m(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < values.size(); ++j) m.at(i, j) = values[i][j];
  return m;
}

}  // namespace

TEST_CASE("The query is left out and equal distances go by number") {
  const std::vector<float> distances{3, 1, 1, 0, 2};
  CHECK(ranked(distances, 3) == std::vector<std::size_t>{1, 2, 4, 0});
  CHECK(ranked(distances, 1) == std::vector<std::size_t>{3, 2, 4, 0});
}

TEST_CASE("Measures of one list, by hand") {
  // C = 3, N = 6: two relevant among five, at places 2 and 4.
  const Measures m = measures_of({false, true, false, true, false}, 2);
  CHECK(m.nearest == 0);
  CHECK(m.first_tier == 0.5);
  CHECK(m.second_tier == 1);
  CHECK(m.e == Approx(2 / (5.0 / 2 + 1)));      // precision 2/5, recall 1
  CHECK(m.dcg == Approx((1 + 0.5) / (1 + 1)));  // 1/log2 2 + 1/log2 4 over 1 + 1/log2 2
  const Measures best = measures_of({true, true, false, false, false}, 2);
  CHECK(best.nearest == 1);
  CHECK(best.first_tier == 1);
  CHECK(best.dcg == Approx(1));
  const Measures small = measures_of({false, true}, 1);  // tiers longer than the list
  CHECK(small.first_tier == 0);
  CHECK(small.second_tier == 1);
  CHECK(small.dcg == Approx(1));  // log2 2 = 1: the benchmark's first two places weigh the same
}

TEST_CASE("E looks at the first 32 only") {
  std::vector<bool> hits(100);
  hits[31] = hits[32] = true;
  CHECK(measures_of(hits, 2).e == Approx(2 / (32.0 + 2)));
  hits[31] = false;
  CHECK(measures_of(hits, 2).e == 0);
}

TEST_CASE("Means over queries and over classes leave small classes out") {
  Classification classes = parse_classification("PSB 1\n3 9\na 0 3 0 1 2\nb 0 4 3 4 5 6\nc 0 2 7 8\n", "nine");
  // Class a finds itself; of b's queries each finds the three others last; c's would count if they did.
  DistanceMatrix m(9);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 9; ++j) {
      const bool same = classes.class_of[i] == classes.class_of[j];
      m.at(i, j) = (classes.class_of[i] == 1) == same ? 2 : 1;
    }
  const Scores s = evaluate(m, classes);
  CHECK(s.micro.nearest == Approx(3.0 / 7));
  CHECK(s.macro.nearest == Approx(1.0 / 2));
  const double last = (1 / std::log2(6.0) + 1 / std::log2(7.0) + 1 / std::log2(8.0)) / (2 + 1 / std::log2(3.0));
  CHECK(s.micro.dcg == Approx((3 + 4 * last) / 7));
  CHECK(s.macro.dcg == Approx((1 + last) / 2));
  CHECK(s.classes[1].mean.dcg == Approx(last));
  CHECK_FALSE(s.classes[2].counts);
  CHECK_FALSE(s.queries[7].counts);
  // A query of a class of three joins no recall below 1/2, one of four none below 1/3.
  for (int j = 1; j < 7; ++j) CHECK(std::isnan(s.precision[j - 1]));
  CHECK(s.precision[7 - 1] == Approx((0.95 * (1.0 / 6) + 0.05 * (2.0 / 7))));  // 7/20 of 3 hits: place 0.05, b alone
  CHECK(s.precision[20 - 1] == Approx((3 * 1 + 4 * (3.0 / 8)) / 7));
}

TEST_CASE("A class that is empty, of one or of two has no part in the means, and nothing breaks") {
  const DistanceMatrix m = rows({{0, 1, 2, 3, 4, 5},
                                 {1, 0, 2, 3, 4, 5},
                                 {1, 2, 0, 3, 4, 5},
                                 {1, 1, 1, 0, 2, 3},
                                 {1, 1, 1, 2, 0, 3},
                                 {1, 1, 1, 1, 1, 0}});
  const Scores s = evaluate(m, six());
  CHECK(s.micro.dcg == Approx(1));
  CHECK(s.macro.first_tier == Approx(1));
  CHECK(s.classes[0].models == 0);
  CHECK(confusion(m, six()) ==
        std::vector<std::vector<std::size_t>>{{0, 0, 0, 0}, {0, 3, 0, 0}, {0, 2, 0, 0}, {0, 1, 0, 0}});
  CHECK_THROWS_AS(evaluate(DistanceMatrix(5), six()), std::invalid_argument);
}

TEST_CASE("A random order hits the class by its share") {
  // 20 classes of 10: precision at every recall is near 9/199, nearest neighbours too.
  std::string text = "PSB 1\n20 200\n";
  for (int c = 0; c < 20; ++c) {
    text += "c" + std::to_string(c) + " 0 10";
    for (int i = 0; i < 10; ++i) text += " " + std::to_string(10 * c + i);
    text += "\n";
  }
  const Classification classes = parse_classification(text, "random");
  rectilin::Random random(1);
  DistanceMatrix m(200);
  for (float& x : m.values()) x = static_cast<float>(random.uniform());
  const Scores s = evaluate(m, classes);
  const double share = 9.0 / 199;
  CHECK(std::abs(s.micro.first_tier - share) < 3 * std::sqrt(share / (200 * 9)));
  CHECK(s.micro.first_tier == Approx(s.macro.first_tier));  // classes of one size
  CHECK(s.precision[19] == Approx(share).epsilon(0.2));
}
