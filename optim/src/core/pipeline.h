#pragma once

#include <vector>

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// Runs optimizers one after another on one budget; each can use the incumbent that those before it have found.
class Pipeline final : public Optimizer {
 public:
  explicit Pipeline(std::vector<std::unique_ptr<const Optimizer>> stages) : stages_(std::move(stages)) {}

  /// The stages' names joined by '+'.
  std::string name() const override;
  /// An array with the parameters of each stage.
  Json parameters() const override;
  Capabilities capabilities() const override;
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;

 private:
  std::vector<std::unique_ptr<const Optimizer>> stages_;
};

}  // namespace rectilin
