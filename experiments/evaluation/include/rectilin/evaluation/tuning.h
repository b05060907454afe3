// From an evaluation to tuned weights, with what they are worth on classes they were not tuned for.
#pragma once

#include <string>
#include <vector>

#include "rectilin/evaluation/evaluation.h"
#include "rectilin/evaluation/weights.h"

namespace rectilin::evaluation {

struct TuningPlan {
  std::string composite;      ///< the terms, as `gsmd+shd+r`; weights in it are ignored
  std::size_t budget = 1000;  ///< evaluations of each search
  std::size_t folds = 5;
  std::uint64_t seed = 1;
};

/// Adds each term as a contestant of its own, unless one with its text is there. Throws ParameterError for a composite
/// of fewer than two terms or with one twice.
void add_terms(std::vector<Contestant>& contestants, const TuningPlan& plan);

struct TuningOutcome {
  bool complete = false;           ///< false: stopped, and nothing was written
  std::vector<std::string> lines;  ///< for people, one for each tuner and one for the file
};

/// Tunes with every tuner there is, on one budget, and cross-validates each. OUT/tuning.json has all of it,
/// OUT/weights.json the weights tuned on all classes by the tuner that did best on unseen ones.
TuningOutcome tune_composite(const TuningPlan& plan, const Evaluation& evaluation, const std::filesystem::path& out,
                             const EvaluationSettings& settings);

}  // namespace rectilin::evaluation
