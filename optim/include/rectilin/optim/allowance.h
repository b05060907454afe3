// Evaluation limit for searches that do not stop by themselves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "rectilin/base/parameters.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// Counts down from `wanted` evaluations (0: all the budget has left, or kUnlimited if it has no
/// limit, neither of evaluations nor of time). Ends with the evaluator's budget at the latest.
class Allowance {
 public:
  static constexpr std::uint64_t kUnlimited = 10000;

  Allowance(const Evaluator& evaluator, std::uint64_t wanted)
      : evaluator_(evaluator),
        timed_(wanted == 0 && evaluator.budget().limits_seconds() && !evaluator.budget().limits_evaluations()),
        end_(timed_ ? kForever : spent_by_all() + granted(wanted)) {}

  std::uint64_t remaining() const { return end_ > spent_by_all() ? end_ - spent_by_all() : 0; }

  /// Is time all that ends it?
  bool timed() const { return timed_; }

  /// Is there no room for another evaluation at this price?
  bool spent(std::uint64_t price = Costs::kPerValue) const { return remaining() < price || evaluator_.exhausted(); }

  /// The length to plan for when a search that must know it ahead (a cooling, a spiral) begins for
  /// the `round`-th time, from 0: all that remains. If only time is limited, 10,000 evaluations,
  /// 20,000, 40,000 and so on: the clock decides where such a run ends, but not what it does until
  /// then, and its last complete round had about a quarter of the time or more.
  std::uint64_t plan(int round) const { return timed_ ? kUnlimited << std::min(round, 40) : remaining(); }

  /// Declares the parameter that becomes `wanted`.
  static void bind(Parameters& table, int& wanted) {
    table.integer("evaluations", wanted, 0, 2000000000,
                  "evaluations at most; 0: what is left of the budget, 10,000 if it has no limit");
  }

 private:
  static constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();

  std::uint64_t spent_by_all() const { return evaluator_.costs().evaluations(); }

  std::uint64_t granted(std::uint64_t wanted) const {
    if (wanted > 0) return std::min(wanted, evaluator_.remaining());
    return evaluator_.budget().limits_evaluations() ? evaluator_.remaining() : kUnlimited;
  }

  const Evaluator& evaluator_;
  bool timed_;
  std::uint64_t end_;
};

}  // namespace rectilin
