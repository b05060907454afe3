#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// Simulated annealing (Kirkpatrick, Gelatt, Vecchi 1983) by random turns of the frame.
/// Temperatures are relative to the spread of the objective over random rotations, so that the same
/// settings suit every mesh; the length of the turns follows the share of moves accepted (as in
/// Corana et al. 1987). With nothing but a limit of time it anneals again and again, each time
/// twice as long (Allowance::plan()), and goes on from the incumbent.
struct AnnealingOptions {
  enum class Cooling { kGeometric, kLinear, kFast, kBoltzmann };
  enum class Reheat { kBest, kRandom };

  int evaluations = 0;
  Cooling cooling = Cooling::kGeometric;
  double hot = 0.5;    ///< first temperature, in standard deviations of the objective
  double cold = 1e-7;  ///< last temperature, likewise
  int cycles = 4;      ///< coolings the evaluations are shared out to
  Reheat reheat = Reheat::kRandom;
  double acceptance = 0.4;  ///< share of accepted moves that the step length is adapted to
  double step = 0.5;        ///< first and longest step: standard deviation of each component of a turn, radians

  void bind(Parameters& table);
};

class Annealing final : public OptimizerWith<AnnealingOptions> {
 public:
  using Options = AnnealingOptions;
  static constexpr const char* kName = "anneal";

  /// Throws ParameterError if the last temperature is above the first.
  explicit Annealing(Options options = {});

  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_domain = false}; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

}  // namespace rectilin
