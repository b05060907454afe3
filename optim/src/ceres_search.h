#pragma once

#include "graduated.h"
#include "restarts.h"

namespace rectilin {

/// L-BFGS with line searches (Ceres: Agarwal, Mierle and others) on the manifold of unit
/// quaternions, minimising the smooth surrogate with ever less smoothing.
struct CeresOptions {
  int starts = 0;
  int iterations = 100;
  Graduation graduation = {};
  void bind(Parameters& table);
};

class CeresSearch final : public RestartedOptimizerWith<CeresOptions> {
 public:
  using Options = CeresOptions;
  static constexpr const char* kName = "ceres";

  explicit CeresSearch(Options options = {}) : RestartedOptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override {
    return {.uses_chart = false, .needs_smooth = true, .local = options_.starts == 1};
  }
  void improve(const Rotation& start, Evaluator& evaluator, const Chart& chart, Random& random) const override;
};

}  // namespace rectilin
