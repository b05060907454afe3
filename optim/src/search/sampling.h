// Evaluates a sequence of rotations in batches.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// Evaluates sample(0), ..., sample(count - 1), in this order, until the budget is spent.
template <class Sample>
void evaluate_all(Evaluator& evaluator, std::uint64_t count, Sample sample) {
  constexpr std::uint64_t kBatch = 1024;  // large enough for all threads, small enough to stop soon
  std::vector<Rotation> rotations;
  std::vector<double> values;
  for (std::uint64_t i = 0; i < count && !evaluator.exhausted();) {
    rotations.clear();
    for (const std::uint64_t end = std::min(count, i + kBatch); i < end; ++i) rotations.push_back(sample(i));
    values.resize(rotations.size());
    evaluator.values(rotations, values);
  }
}

}  // namespace rectilin
