#pragma once

#include "rectilin/optim/local.h"

namespace rectilin {

/// Nelder and Mead (1965) on rotations, see simplex.h. On kinks a simplex may flatten and stop
/// short of a minimum; a new one, set up where it stopped, finds out (Kelley 1999);
/// papers/optimizers.md says how often.
struct NelderMeadOptions {
  double size = 0.3;
  double tolerance = 1e-9;
  int restarts = 1;
  void bind(Parameters& table);
};

class NelderMead final : public LocalOptimizerWith<NelderMeadOptions> {
 public:
  using Options = NelderMeadOptions;
  static constexpr const char* kName = "nelder-mead";

  explicit NelderMead(Options options = {}) : LocalOptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_domain = false, .local = true}; }
  void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

}  // namespace rectilin
