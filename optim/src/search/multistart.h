#pragma once

#include "rectilin/optim/local.h"
#include "rectilin/optim/registry.h"

namespace rectilin {

/// A local method from many uniformly random starts. The defaults, thirty runs of Nelder and Mead's
/// method, are how this measure is computed in public code.
struct MultistartOptions {
  std::string local = "nelder-mead";
  int starts = 30;
  void bind(Parameters& table);
};

class Multistart final : public OptimizerWith<MultistartOptions> {
 public:
  using Options = MultistartOptions;
  static constexpr const char* kName = "multistart";

  /// Throws ParameterError if `local` is not a local optimizer of `registry`.
  Multistart(Options options, const Registry& registry);

  std::string name() const override { return kName; }
  Capabilities capabilities() const override;
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;

 private:
  std::shared_ptr<const Optimizer> optimizer_;
  const LocalSearch* local_;  ///< the same object
};

}  // namespace rectilin
