#pragma once

#include "graduated.h"
#include "rectilin/optim/local.h"

namespace rectilin {

/// L-BFGS with line searches (Ceres: Agarwal, Mierle and others) on the manifold of unit
/// quaternions, minimising the smooth surrogate with ever less smoothing.
struct CeresOptions {
  int starts = 0;
  int iterations = 100;
  Graduation graduation = {};
  void bind(Parameters& table);
};

class CeresSearch final : public LocalOptimizerWith<CeresOptions> {
 public:
  using Options = CeresOptions;
  static constexpr const char* kName = "ceres";

  explicit CeresSearch(Options options = {}) : LocalOptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override {
    return {.uses_chart = false, .local = options_.starts == 1};
  }
  void run(Evaluator& evaluator, const Chart& chart, Random& random) const override;
  /// Throws ParameterError if the objective has no smooth surrogate.
  void improve(const Rotation& start, Evaluator& evaluator, const Chart& chart,
               Random& random) const override;
};

}  // namespace rectilin
