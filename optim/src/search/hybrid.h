#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// The search of Chang, Gorissen and Melchior (2011) for the smallest box round a solid, here for
/// this objective: a population of simplices of four rotations. The better half breeds, by swapping
/// vertices and by mixing them on the group, and the children mutate by some steps of Nelder and
/// Mead's method. A population that no longer gains is replaced by a new one.
struct HybridOptions {
  int evaluations = 0;
  int population = 30;  ///< simplices, M
  int steps = 20;       ///< Nelder-Mead iterations a generation, K
  int patience = 5;     ///< generations without gain that end a population
  double gain = 1e-6;   ///< relative decrease of the value that counts as one
  void bind(Parameters& table);
};

class HybridSearch final : public OptimizerWith<HybridOptions> {
 public:
  using Options = HybridOptions;
  static constexpr const char* kName = "hybrid";

  explicit HybridSearch(Options options = {}) : OptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_domain = false}; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

}  // namespace rectilin
