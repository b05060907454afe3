#pragma once

#include "rectilin/optim/restarts.h"

namespace rectilin {

/// Exact coordinate descent: the frame is turned about its first, second, third, first... axis to
/// the best of all turns (the planar problem of Zunic and Rosin 2003), until three turns in a row
/// have not helped. The end point need not be a local minimum: turns about two axes at once may
/// still lead downhill.
struct AxisSweepOptions {
  int starts = 0;
  double tolerance = 1e-12;
  void bind(Parameters& table);
};

class AxisSweep final : public RestartedOptimizerWith<AxisSweepOptions> {
 public:
  using Options = AxisSweepOptions;
  static constexpr const char* kName = "axis-sweep";

  explicit AxisSweep(Options options = {}) : RestartedOptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override {
    return {.uses_domain = false, .needs_turns = true, .local = options_.starts == 1};
  }
  void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

}  // namespace rectilin
