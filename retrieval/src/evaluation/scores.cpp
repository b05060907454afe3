#include "rectilin/retrieval/scores.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace rectilin::retrieval {
namespace {

constexpr NamedMeasure kMeasures[] = {{"NN", &Measures::nearest},
                                      {"FT", &Measures::first_tier},
                                      {"ST", &Measures::second_tier},
                                      {"E", &Measures::e},
                                      {"DCG", &Measures::dcg}};
constexpr std::size_t kFirstPage = 32;     // results that E looks at
constexpr std::size_t kSmallestClass = 3;  // that is in the means

/// What an item in place i (from 1) is worth.
double gain(std::size_t i) { return i == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(i)); }

double share(std::size_t part, std::size_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

/// Precision at each of the query's hits, in order, interpolated at the recalls; NaN where the query does not join.
PrecisionCurve precision_curve(const std::vector<bool>& hits, std::size_t relevant) {
  std::vector<double> at_hit;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (hits[i]) at_hit.push_back(share(at_hit.size() + 1, i + 1));
  PrecisionCurve curve;
  curve.fill(std::numeric_limits<double>::quiet_NaN());
  if (relevant < 2) return curve;
  for (std::size_t j = 1; j <= kRecalls; ++j) {
    if (relevant * j < kRecalls) continue;  // one hit would already be a higher recall
    const std::size_t place = relevant * j - kRecalls, below = place / kRecalls;  // place in twentieths
    const double weight = share(place % kRecalls, kRecalls);
    curve[j - 1] = weight == 0 ? at_hit[below] : (1 - weight) * at_hit[below] + weight * at_hit[below + 1];
  }
  return curve;
}

void add(Measures& sum, const Measures& term, double weight) {
  for (const NamedMeasure& m : kMeasures) sum.*m.value += weight * term.*m.value;
}

}  // namespace

std::span<const NamedMeasure> named_measures() { return kMeasures; }

std::vector<std::size_t> ranked(std::span<const float> distances, std::size_t query) {
  std::vector<std::size_t> order(distances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase(order, query);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return distances[i]; });
  return order;
}

Measures measures_of(const std::vector<bool>& hits, std::size_t relevant) {
  const auto among_first = [&](std::size_t places) {
    places = std::min(places, hits.size());
    return static_cast<std::size_t>(std::count(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(places), true));
  };
  Measures m;
  m.nearest = among_first(1) > 0 ? 1 : 0;
  m.first_tier = share(among_first(relevant), relevant);
  m.second_tier = share(among_first(2 * relevant), relevant);
  const std::size_t page = std::min(kFirstPage, hits.size());
  if (const std::size_t found = among_first(page); found > 0)
    m.e = 2 / (1 / share(found, page) + 1 / share(found, relevant));
  double reached = 0, ideal = 0;
  for (std::size_t i = 1; i <= hits.size(); ++i) {
    if (hits[i - 1]) reached += gain(i);
    if (i <= relevant) ideal += gain(i);
  }
  m.dcg = reached / ideal;
  return m;
}

Scores evaluate(const DistanceMatrix& matrix, const Classification& classes) {
  const std::size_t n = matrix.size();
  if (classes.models.size() != n) throw std::invalid_argument("a matrix and a classification of different sizes");
  Scores scores;
  scores.queries.resize(n);
  std::vector<PrecisionCurve> curves(n);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t q) {
    const std::size_t own = classes.class_of[q], size = classes.classes[own].models.size();
    QueryScore& score = scores.queries[q];
    score.counts = size >= kSmallestClass;
    if (size < 2) return;
    std::vector<bool> hits;
    hits.reserve(n - 1);
    for (const std::size_t i : ranked({matrix.row(q), n}, q)) hits.push_back(classes.class_of[i] == own);
    score.measures = measures_of(hits, size - 1);
    curves[q] = precision_curve(hits, size - 1);
  });

  std::size_t counted_queries = 0, counted_classes = 0;
  std::array<std::size_t, kRecalls> joined{};
  for (const Classification::Class& c : classes.classes) {
    ClassScore& score = scores.classes.emplace_back();
    score.models = c.models.size();
    score.counts = c.models.size() >= kSmallestClass;
    for (const std::size_t q : c.models) add(score.mean, scores.queries[q].measures, 1.0 / share(score.models, 1));
    if (!score.counts) continue;
    ++counted_classes;
    add(scores.macro, score.mean, 1);
    for (const std::size_t q : c.models) {
      ++counted_queries;
      add(scores.micro, scores.queries[q].measures, 1);
      for (std::size_t j = 0; j < kRecalls; ++j) {
        if (std::isnan(curves[q][j])) continue;
        scores.precision[j] += curves[q][j];
        ++joined[j];
      }
    }
  }
  const auto divide = [](Measures& sum, std::size_t count) {
    Measures mean;
    if (count > 0) add(mean, sum, 1 / share(count, 1));
    sum = mean;
  };
  divide(scores.micro, counted_queries);
  divide(scores.macro, counted_classes);
  for (std::size_t j = 0; j < kRecalls; ++j) {
    if (joined[j] > 0) scores.precision[j] /= share(joined[j], 1);
    else scores.precision[j] = std::numeric_limits<double>::quiet_NaN();
  }
  return scores;
}

std::vector<std::vector<std::size_t>> confusion(const DistanceMatrix& matrix, const Classification& classes) {
  const std::size_t n = matrix.size(), k = classes.classes.size();
  std::vector<std::vector<std::size_t>> counts(k, std::vector<std::size_t>(k));
  for (std::size_t q = 0; q < n && n > 1; ++q) {
    std::size_t nearest = q == 0 ? 1 : 0;
    for (std::size_t i = 0; i < n; ++i)
      if (i != q && matrix.at(q, i) < matrix.at(q, nearest)) nearest = i;
    ++counts[classes.class_of[q]][classes.class_of[nearest]];
  }
  return counts;
}

}  // namespace rectilin::retrieval
