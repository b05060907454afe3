// How well distances find a query's class: the measures of the Princeton Shape Benchmark, to the letter of its tools.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "rectilin/retrieval/classification.h"
#include "rectilin/retrieval/distance_matrix.h"

namespace rectilin::retrieval {

/// Measures of a ranked list, each within [0, 1] (Shilane et al. 2004, section 4). Of N models C are of the query's
/// class; the query itself is not in the list, and rel_i is 1 if the i-th is of its class, else 0.
struct Measures {
  double nearest = 0;      ///< rel_1
  double first_tier = 0;   ///< hits among the first C-1, over C-1
  double second_tier = 0;  ///< hits among the first min(2(C-1), N-1), over C-1
  double e = 0;            ///< 2 / (1/P + 1/R), precision and recall of the first min(32, N-1)
  double dcg = 0;          ///< (rel_1 + sum_{i=2}^{N-1} rel_i / log2 i) / (1 + sum_{i=2}^{C-1} 1 / log2 i)
};

/// Names and places of the measures, for tables and loops.
struct NamedMeasure {
  const char* name;
  double Measures::*value;
};
std::span<const NamedMeasure> named_measures();

inline constexpr std::size_t kRecalls = 20;  ///< 0.05, 0.10, ..., 1
using PrecisionCurve = std::array<double, kRecalls>;

struct QueryScore {
  bool counts = false;  ///< it is in the means: its class has more than two models
  Measures measures;
};

struct ClassScore {
  std::size_t models = 0;
  bool counts = false;  ///< more than two models
  Measures mean;
};

struct Scores {
  Measures micro;                   ///< mean over the queries that count
  Measures macro;                   ///< mean over the classes that count of the means over their models
  PrecisionCurve precision{};       ///< mean precision at each recall; NaN where no query joins
  std::vector<QueryScore> queries;  ///< in the matrix's order
  std::vector<ClassScore> classes;  ///< in the order of the classification
};

/// The models in the order of their distance, the query left out; equal distances in the order of the matrix.
std::vector<std::size_t> ranked(std::span<const float> distances, std::size_t query);

/// Of a ranked list: for each place whether it is a hit, and the number of hits there are (C-1 >= 1).
Measures measures_of(const std::vector<bool>& hits, std::size_t relevant);

/// Scores of a matrix whose rows are the models of `classes`, in their order. Classes of two or less are left out of
/// all means but stay in the lists as models that may be found. Throws std::invalid_argument if the sizes differ.
Scores evaluate(const DistanceMatrix& matrix, const Classification& classes);

/// counts[a][b]: of the queries of class a, those whose nearest model is of class b.
std::vector<std::vector<std::size_t>> confusion(const DistanceMatrix& matrix, const Classification& classes);

}  // namespace rectilin::retrieval
