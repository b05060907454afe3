// Descents that begin again when they have converged.
#pragma once

#include "rectilin/optim/local.h"

namespace rectilin {

/// Declares the number of starts that improve_from_starts() takes; `what` they are.
inline void bind_starts(Parameters& table, int& starts, std::string what) {
  what += "; 0: until the budget is spent, 10,000 evaluations if it has no limit";
  table.integer("starts", starts, 0, 1000000000, std::move(what));
}

/// Base of an optimizer that repeats its descent `options.starts` times, first from the incumbent,
/// if there is one, then from random rotations. Derive, write improve(), and call it local if there
/// is one start.
template <class Options>
class RestartedOptimizerWith : public LocalOptimizerWith<Options> {
 public:
  using LocalOptimizerWith<Options>::LocalOptimizerWith;

  void run(Evaluator& evaluator, const Domain& domain, Random& random) const final {
    improve_from_starts(*this, this->options_.starts, /*from_incumbent=*/true, evaluator, domain, random);
  }
};

}  // namespace rectilin
