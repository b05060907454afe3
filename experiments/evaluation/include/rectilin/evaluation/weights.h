// Weights of a composite descriptor, tuned for the score they give on a collection.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/base/parameters.h"
#include "rectilin/retrieval/classification.h"
#include "rectilin/retrieval/distance_matrix.h"

namespace rectilin::evaluation {

/// What is tuned: DCG (micro) of the weighted sum of matrices, as a function of the weights. Weights lie in [0, 1], and
/// only their ratios matter. Rows are models of `classes`. Const members are thread safe.
class WeightedScore {
 public:
  /// Queries are the models for which `query` is true and whose class has more than two models among those for which
  /// `database` is true; only the latter are ranked.
  WeightedScore(std::vector<const retrieval::DistanceMatrix*> terms, const retrieval::Classification& classes,
                std::vector<bool> query, std::vector<bool> database);

  std::size_t terms() const { return terms_.size(); }
  std::size_t queries() const { return queries_.size(); }

  /// Mean DCG of the queries; 0 if all weights are zero. The same bits for any number of threads.
  double operator()(const std::vector<double>& weights) const;

  /// DCG of each query, in the order of the models; NaN for other models.
  std::vector<double> by_query(const std::vector<double>& weights) const;

 private:
  double dcg(std::size_t query, const std::vector<double>& weights) const;

  std::vector<const retrieval::DistanceMatrix*> terms_;
  const retrieval::Classification& classes_;
  std::vector<bool> database_;
  std::vector<std::size_t> queries_;
  std::vector<std::size_t> size_;  ///< models of each class in the database
};

/// The searchers of weights: `ga`, a genetic algorithm with real genes, and where they were built in `nlopt` (DIRECT-L
/// then Sbplx) and `pagmo` (CMA-ES). All maximise within the same number of evaluations; the result depends on the seed
/// alone.
std::vector<std::string> tuners();

struct Tuned {
  std::vector<double> weights;  ///< the largest is 1
  double score = 0;
  std::size_t evaluations = 0;
};
Tuned tune(const std::string& tuner, const std::function<double(const std::vector<double>&)>& score, std::size_t terms,
           std::size_t budget, std::uint64_t seed, std::stop_token stop = {});

/// How well tuning does on classes it has not seen.
struct CrossValidation {
  std::vector<Tuned> folds;
  double seen = 0;    ///< DCG on the classes that were tuned for, mean over the folds
  double unseen = 0;  ///< DCG of each query with the weights tuned without its class, ranked among all models
  double equal = 0;   ///< DCG of all queries with equal weights
};

/// Classes go to `folds` folds at random. Weights are tuned on the models of all folds but one, both as queries and as
/// what is ranked.
CrossValidation cross_validate(const std::string& tuner, const std::vector<const retrieval::DistanceMatrix*>& terms,
                               const retrieval::Classification& classes, std::size_t folds, std::size_t budget,
                               std::uint64_t seed, std::stop_token stop = {});

/// A file with weights: JSON with a list `terms` of objects `weight` and `descriptor`, beside whatever else says where
/// they come from. Read, it is a text for retrieval::make_descriptor(). Terms of weight zero are left out.
void write_weights(const std::filesystem::path& file, const std::vector<std::string>& descriptors,
                   const std::vector<double>& weights, const Json& origin);

/// Throws ParameterError, "FILE: reason", if it is no such file.
std::string read_weights(const std::filesystem::path& file);

}  // namespace rectilin::evaluation
