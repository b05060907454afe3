#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// Uniformly random rotations: the yardstick that every other optimizer has to beat.
struct RandomSearchOptions {
  int evaluations = 0;
  void bind(Parameters& table);
};

class RandomSearch final : public OptimizerWith<RandomSearchOptions> {
 public:
  using Options = RandomSearchOptions;
  static constexpr const char* kName = "random";

  explicit RandomSearch(Options options = {}) : OptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_domain = false, .batches = true}; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

}  // namespace rectilin
