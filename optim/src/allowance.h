// What a search without an end of its own may spend.
#pragma once

#include <algorithm>
#include <cstdint>

#include "rectilin/optim/evaluator.h"
#include "rectilin/optim/parameters.h"

namespace rectilin {

/// Counts down from `wanted` evaluations (0: all the budget has left, or kUnlimited if it has no
/// limit). Ends with the evaluator's budget at the latest.
class Allowance {
 public:
  static constexpr std::uint64_t kUnlimited = 10000;

  Allowance(const Evaluator& evaluator, int wanted)
      : evaluator_(evaluator), end_(spent_by_all() + granted(static_cast<std::uint64_t>(wanted))) {}

  std::uint64_t remaining() const { return end_ > spent_by_all() ? end_ - spent_by_all() : 0; }

  /// Is there no room for another evaluation at this price?
  bool spent(std::uint64_t price = Costs::kPerValue) const {
    return remaining() < price || evaluator_.exhausted();
  }

  /// Declares the parameter that becomes `wanted`.
  static void bind(Parameters& table, int& wanted) {
    table.integer("evaluations", wanted, 0, 2000000000,
                  "evaluations at most; 0: what is left of the budget, 10,000 if it has no limit");
  }

 private:
  std::uint64_t spent_by_all() const { return evaluator_.costs().evaluations(); }

  std::uint64_t granted(std::uint64_t wanted) const {
    // A budget without a limit is the largest number there is, less what has been spent.
    const bool limited = evaluator_.remaining() < Budget().evaluations / 2;
    if (wanted == 0) return limited ? evaluator_.remaining() : kUnlimited;
    return std::min(wanted, evaluator_.remaining());
  }

  const Evaluator& evaluator_;
  std::uint64_t end_;
};

}  // namespace rectilin
