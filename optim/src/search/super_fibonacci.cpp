// Rotations of a super-Fibonacci spiral.
#include "search/super_fibonacci.h"

#include <cmath>
#include <numbers>

#include "rectilin/optim/allowance.h"
#include "rectilin/optim/registry.h"
#include "search/sampling.h"

namespace rectilin {
namespace {

/// The rotations of a super-Fibonacci spiral (Alexa 2022): a sequence on the sphere of unit quaternions that is spread
/// more evenly than random ones. The whole sequence depends on the number of points. If only a time limit is set, one
/// spiral follows another, each with twice as many points.
struct SuperFibonacciOptions {
  int count = 0;
  void bind(Parameters& table);
};

void SuperFibonacciOptions::bind(Parameters& table) {
  table.integer("count", count, 0, 2000000000, "points; 0: what is left of the budget, or 10,000 if it has no limit");
}

void search_spirals(const SuperFibonacciOptions& options, Evaluator& evaluator, const Domain&, Random&) {
  const Allowance allowance(evaluator, options.count);
  for (int round = 0; !allowance.spent(); ++round) {
    const std::uint64_t count = allowance.plan(round);
    evaluate_all(evaluator, count, [count](std::uint64_t i) { return super_fibonacci(i, count); });
  }
}

}  // namespace

Rotation super_fibonacci(std::uint64_t i, std::uint64_t count) {
  // The spiral turns along two circles by incommensurable angles: psi^4 = psi + 4 (Alexa 2022, section 4).
  constexpr double kPhi = std::numbers::sqrt2, kPsi = 1.533751168755204288118041;
  const double s = static_cast<double>(i) + 0.5, t = s / static_cast<double>(count);
  const double alpha = 2 * std::numbers::pi * s / kPhi, beta = 2 * std::numbers::pi * s / kPsi;
  const double r = std::sqrt(t), q = std::sqrt(1 - t);
  return Rotation::from_quaternion({q * std::cos(beta), r * std::sin(alpha), r * std::cos(alpha), q * std::sin(beta)});
}

void add_super_fibonacci(Registry& registry) {
  registry.add(
      GlobalMethod<SuperFibonacciOptions>{.name = "super-fibonacci",
                                          .help = "evenly spread rotations (Alexa 2022)",
                                          .capabilities = {.uses_domain = false, .uses_random = false, .batches = true},
                                          .run = search_spirals});
}

}  // namespace rectilin
