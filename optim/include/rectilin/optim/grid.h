// Exhaustive search (paper, section 4.3, note 3), refined where it looks best.
#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// First `points`^3 nodes spread over the domain's box, ends included; then, `levels` times, a grid of
/// `refine`^3 nodes over the neighbourhood (one spacing to each side) of each of the `keep` best nodes so
/// far. The defaults spend the genetic algorithm's 10,000 evaluations. The third coordinate runs fastest:
/// on the Euler domains all nodes of such a line have the same third axis, and the objective shares its h.
struct GridOptions {
  int points = 20;
  int levels = 2;
  int keep = 8;
  int refine = 5;

  void bind(Parameters& table);
};

class GridSearch final : public OptimizerWith<GridOptions> {
 public:
  using Options = GridOptions;
  static constexpr const char* kName = "grid";

  explicit GridSearch(Options options = {}) : OptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_random = false, .batches = true}; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

}  // namespace rectilin
