// Evaluation limit for searches that do not stop by themselves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "rectilin/base/parameters.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// Counts down from `wanted` evaluations. 0 stands for all that the budget has left, or for kUnlimited if the budget
/// limits neither evaluations nor time. Never lasts longer than the evaluator's budget.
class Allowance {
 public:
  static constexpr std::uint64_t kUnlimited = 10000;

  Allowance(const Evaluator& evaluator, std::uint64_t wanted)
      : evaluator_(evaluator),
        timed_(wanted == 0 && evaluator.budget().limits_seconds() && !evaluator.budget().limits_evaluations()),
        end_(timed_ ? kForever : spent_by_all() + granted(wanted)) {}

  std::uint64_t remaining() const { return end_ > spent_by_all() ? end_ - spent_by_all() : 0; }

  /// Is time the only limit?
  bool timed() const { return timed_; }

  /// Is too little left for another evaluation at this price?
  bool spent(std::uint64_t price = Costs::kPerValue) const { return remaining() < price || evaluator_.exhausted(); }

  /// How many evaluations to plan for, for a search that must know its length beforehand (a cooling schedule, a
  /// spiral), when it begins for the `round`-th time, counted from 0. It is all that remains or, if only time is
  /// limited, 10,000, then 20,000, 40,000 and so on: the clock decides where such a run ends but not what it does until
  /// then, and its last complete round had at least about a quarter of the time.
  std::uint64_t plan(int round) const { return timed_ ? kUnlimited << std::min(round, 40) : remaining(); }

  /// Declares the setting that becomes `wanted`.
  static void bind(Parameters& table, int& wanted) {
    table.integer("evaluations", wanted, 0, 2000000000,
                  "most evaluations; 0: what is left of the budget, or 10,000 if it has no limit");
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
