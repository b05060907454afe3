#include "rectilin/evaluation/weights.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "rectilin/base/random.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/retrieval/descriptor.h"

namespace rectilin::evaluation {

using retrieval::Classification;
using retrieval::DistanceMatrix;

WeightedScore::WeightedScore(std::vector<const DistanceMatrix*> terms, const Classification& classes,
                             std::vector<bool> query, std::vector<bool> database)
    : terms_(std::move(terms)), classes_(classes), database_(std::move(database)), size_(classes.classes.size()) {
  for (std::size_t i = 0; i < database_.size(); ++i) size_[classes.class_of[i]] += database_[i];
  for (std::size_t i = 0; i < query.size(); ++i)
    if (query[i] && database_[i] && size_[classes.class_of[i]] > 2) queries_.push_back(i);
}

/// The places of the hits are counted, not sorted for: a class is much smaller than the collection.
double WeightedScore::dcg(std::size_t query, const std::vector<double>& weights) const {
  const std::size_t n = database_.size();
  std::vector<float> distance(n);
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const auto weight = static_cast<float>(weights[t]);
    const float* row = terms_[t]->row(query);
    for (std::size_t i = 0; i < n; ++i) distance[i] += weight * row[i];
  }
  constexpr float kLast = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < n; ++i)
    if (!database_[i]) distance[i] = kLast;
  distance[query] = kLast;
  const std::size_t own = classes_.class_of[query];
  double reached = 0, ideal = 0;
  std::size_t place = 0;
  for (const std::size_t hit : classes_.classes[own].models) {
    if (hit == query || !database_[hit]) continue;
    const float d = distance[hit];
    std::size_t before = 0;
    for (std::size_t i = 0; i < n; ++i) before += static_cast<std::size_t>(distance[i] < d);
    for (std::size_t i = 0; i < hit; ++i) before += static_cast<std::size_t>(distance[i] == d);
    const auto gain = [](std::size_t i) { return i <= 1 ? 1.0 : 1 / std::log2(static_cast<double>(i)); };
    reached += gain(before + 1);
    ideal += gain(++place);
  }
  return reached / ideal;
}

double WeightedScore::operator()(const std::vector<double>& weights) const {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(sum > 0) || queries_.empty()) return 0;
  std::vector<double> scores(queries_.size());
  tbb::parallel_for(std::size_t{0}, queries_.size(), [&](std::size_t q) { scores[q] = dcg(queries_[q], weights); });
  return std::accumulate(scores.begin(), scores.end(), 0.0) / static_cast<double>(scores.size());
}

std::vector<double> WeightedScore::by_query(const std::vector<double>& weights) const {
  std::vector<double> scores(database_.size(), std::numeric_limits<double>::quiet_NaN());
  tbb::parallel_for(std::size_t{0}, queries_.size(),
                    [&](std::size_t q) { scores[queries_[q]] = dcg(queries_[q], weights); });
  return scores;
}

CrossValidation cross_validate(const std::string& tuner, const std::vector<const DistanceMatrix*>& terms,
                               const Classification& classes, std::size_t folds, std::size_t budget, std::uint64_t seed,
                               std::stop_token stop) {
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < classes.classes.size(); ++c)
    if (!classes.classes[c].models.empty()) order.push_back(c);
  Random random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::vector<std::size_t> fold_of(classes.classes.size());
  for (std::size_t i = 0; i < order.size(); ++i) fold_of[order[i]] = i % folds;

  const std::size_t n = classes.models.size();
  const std::vector<bool> all(n, true);
  CrossValidation result;
  result.equal = WeightedScore(terms, classes, all, all)(std::vector<double>(terms.size(), 1));
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t fold = 0; fold < folds && !stop.stop_requested(); ++fold) {
    std::vector<bool> inside(n), outside(n);
    for (std::size_t i = 0; i < n; ++i) {
      inside[i] = fold_of[classes.class_of[i]] != fold;
      outside[i] = !inside[i];
    }
    const WeightedScore training(terms, classes, inside, inside);
    result.folds.push_back(tune(
        tuner, [&](const auto& w) { return training(w); }, terms.size(), budget, random.fork(fold).bits(), stop));
    result.seen += result.folds.back().score / static_cast<double>(folds);
    for (const double dcg : WeightedScore(terms, classes, outside, all).by_query(result.folds.back().weights)) {
      if (std::isnan(dcg)) continue;
      sum += dcg;
      ++count;
    }
  }
  if (count > 0) result.unseen = sum / static_cast<double>(count);
  return result;
}

void write_weights(const std::filesystem::path& file, const std::vector<std::string>& descriptors,
                   const std::vector<double>& weights, const Json& origin) {
  Json terms = Json::array();
  for (std::size_t i = 0; i < descriptors.size(); ++i)
    terms.push_back({{"weight", weights[i]}, {"descriptor", descriptors[i]}});
  write_whole_file(file, to_text({{"terms", terms}, {"origin", origin}}, 1) + '\n');
}

std::string read_weights(const std::filesystem::path& file) {
  if (const std::error_code error = why_unreadable(file))
    throw ParameterError(file.string() + ": " + system_reason(error));
  std::string text;
  try {
    const Json json = parse_json(read_whole_file(file));
    for (const Json& term : json.at("terms")) {
      const double weight = term.at("weight").get<double>();
      if (!(weight >= 0)) throw ParameterError(file.string() + ": a weight is negative");
      if (weight > 0)
        text += (text.empty() ? "" : "+") + to_text(weight) + "*" + term.at("descriptor").get<std::string>();
    }
  } catch (const Json::exception&) {
    throw ParameterError(file.string() + ": is no file of weights");
  }
  if (text.empty()) throw ParameterError(file.string() + ": has no weight above zero");
  return text;
}

}  // namespace rectilin::evaluation
