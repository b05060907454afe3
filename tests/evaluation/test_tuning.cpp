// Weights: what they are scored by, whether searches find good ones, and the files they go to.
#include <cmath>
#include <fstream>

#include "rectilin/base/random.h"
#include "rectilin/evaluation/evaluation.h"
#include "rectilin/evaluation/weights.h"
#include "rectilin/retrieval/scores.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

using namespace rectilin;
using namespace rectilin::evaluation;
using retrieval::Classification;
using retrieval::DistanceMatrix;

namespace {

/// Ten classes of six.
Classification classes() {
  std::string text = "PSB 1\n10 60\n";
  for (int c = 0; c < 10; ++c) {
    text += "c" + std::to_string(c) + " 0 6";
    for (int i = 0; i < 6; ++i) text += " " + std::to_string(6 * c + i);
    text += '\n';
  }
  return retrieval::parse_classification(text, "test");
}

/// Distances that are smaller inside classes by `signal`, the rest of them random.
DistanceMatrix noisy(const Classification& c, double signal, std::uint64_t seed) {
  Random random(seed);
  DistanceMatrix m(c.models.size());
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      m.at(i, j) = m.at(j, i) = static_cast<float>(random.uniform() + (c.class_of[i] == c.class_of[j] ? 0 : signal));
  return m;
}

}  // namespace

TEST_CASE("The score of weights is the DCG of the weighted sum") {
  const Classification c = classes();
  const DistanceMatrix a = noisy(c, 0.3, 1), b = noisy(c, 0.1, 2);
  const std::vector<bool> all(60, true);
  const WeightedScore score({&a, &b}, c, all, all);
  DistanceMatrix sum(60);
  for (std::size_t i = 0; i < sum.values().size(); ++i) sum.values()[i] = 0.5f * a.values()[i] + 0.25f * b.values()[i];
  CHECK(score({0.5, 0.25}) == Approx(retrieval::evaluate(sum, c).micro.dcg));
  CHECK(score({1, 0}) == Approx(retrieval::evaluate(a, c).micro.dcg));
  CHECK(score({0, 0}) == 0);
  std::vector<bool> half(60);
  for (std::size_t i = 0; i < 30; ++i) half[i] = true;
  DistanceMatrix small(30);
  for (std::size_t i = 0; i < 30; ++i)
    for (std::size_t j = 0; j < 30; ++j) small.at(i, j) = a.at(i, j);
  CHECK(WeightedScore({&a}, c, half, half)({1}) == Approx(retrieval::evaluate(small, c.subset(half)).micro.dcg));
}

TEST_CASE("Every tuner keeps its budget, prefers what helps and repeats itself") {
  const Classification c = classes();
  const DistanceMatrix good = noisy(c, 0.3, 1), useless = noisy(c, 0, 2), helps = noisy(c, 0.25, 3);
  const std::vector<bool> all(60, true);
  const WeightedScore score({&useless, &good, &helps}, c, all, all);
  const auto f = [&](const std::vector<double>& w) { return score(w); };
  for (const std::string& tuner : tuners()) {
    INFO(tuner);
    const Tuned tuned = tune(tuner, f, 3, 300, 7);
    CHECK(tuned.evaluations <= 300);
    CHECK(tuned.weights == tune(tuner, f, 3, 300, 7).weights);
    CHECK(*std::ranges::max_element(tuned.weights) == 1);
    CHECK(tuned.score == Approx(score(tuned.weights)));
    CHECK(tuned.score >= score({0, 1, 1}) - 0.005);
    CHECK(tuned.weights[0] < 0.5);
  }
  CHECK_THROWS_AS(tune("luck", f, 3, 10, 1), ParameterError);
}

TEST_CASE("Cross-validation scores every query by weights that have not seen its class") {
  const Classification c = classes();
  const DistanceMatrix good = noisy(c, 0.4, 1), useless = noisy(c, 0, 2);
  const CrossValidation v = cross_validate("ga", {&good, &useless}, c, 5, 100, 1);
  REQUIRE(v.folds.size() == 5);
  CHECK(v.unseen > v.equal);
  CHECK(v.unseen <= retrieval::evaluate(good, c).micro.dcg + 0.02);
}

TEST_CASE("Weights go to a file and come back as a sum; other files are refused") {
  const test::ScratchFolder folder;
  const auto file = folder.path() / "weights.json";
  write_weights(file, {"d2", "r", "shd?grid=32"}, {1, 0, 0.25}, Json::object());
  CHECK(read_weights(file) == "1.0*d2+0.25*shd?grid=32");
  const auto contestants = parse_contestants({"tuned=@" + file.string() + ", d1"});
  REQUIRE(contestants.size() == 2);
  CHECK(contestants[0].label == "tuned");
  CHECK(contestants[0].text == "1.0*d2+0.25*shd?grid=32");
  std::ofstream(folder.path() / "bad.json") << "{}";
  CHECK_THROWS_AS(read_weights(folder.path() / "bad.json"), ParameterError);
  CHECK_THROWS_AS(read_weights("/nowhere.json"), ParameterError);
}

TEST_CASE("Lists of descriptors are split, labelled and checked") {
  const auto c = parse_contestants({"d2, mine=gsmd?views=6&size=64 r+0.5*d1", "both=0.5*d1+r"});
  REQUIRE(c.size() == 4);
  CHECK(c[0].label == "d2");
  CHECK(c[1].label == "mine");
  CHECK(c[1].text == "gsmd?views=6&size=64");
  CHECK(c[2].label == "r+0.5*d1");
  CHECK(c[3].text == "0.5*d1+r");
  CHECK_THROWS_WITH(parse_contestants({"d2,d2"}), Catch::Contains("'d2' is there twice"));
  CHECK_THROWS_AS(parse_contestants({"d3"}), ParameterError);
}
