#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// The rotations of a super-Fibonacci spiral (Alexa 2022): a sequence on the sphere of unit
/// quaternions, spread more evenly than random ones. The number of points is part of the sequence:
/// all change with it. With nothing but a limit of time, one spiral after the other, each of twice
/// as many points.
struct SuperFibonacciOptions {
  int count = 0;
  void bind(Parameters& table);
};

class SuperFibonacci final : public OptimizerWith<SuperFibonacciOptions> {
 public:
  using Options = SuperFibonacciOptions;
  static constexpr const char* kName = "super-fibonacci";

  explicit SuperFibonacci(Options options = {}) : OptimizerWith(options) {}

  std::string name() const override { return kName; }
  Capabilities capabilities() const override { return {.uses_domain = false, .uses_random = false, .batches = true}; }
  void run(Evaluator& evaluator, const Domain& domain, Random& random) const override;
};

/// Point i of `count`, 0 <= i < count.
Rotation super_fibonacci(std::uint64_t i, std::uint64_t count);

}  // namespace rectilin
