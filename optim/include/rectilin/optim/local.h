// Local methods: searches that improve one given start.
#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// What a local optimizer offers besides run(): a descent from a start of the caller's choice.
/// Thread safe like the optimizer it belongs to.
class LocalSearch {
 public:
  virtual ~LocalSearch() = default;

  /// Searches from `start` until it has converged (which is no evidence of a minimum) or the budget
  /// is spent.
  virtual void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const = 0;
};

/// Where a local method starts if nobody says: the evaluator's incumbent or, if there is none, a
/// random rotation.
Rotation start_of(const Evaluator& evaluator, Random& random);

/// Runs `local` from `starts` uniformly random rotations, or until the budget is spent if `starts`
/// is 0 (or 10,000 evaluations, if the budget has no limit). With `from_incumbent` the first start
/// is start_of() instead.
void improve_from_starts(const LocalSearch& local, int starts, bool from_incumbent, Evaluator& evaluator,
                         const Domain& domain, Random& random);

/// Declares the number of starts that improve_from_starts() takes; `what` they are.
void bind_starts(Parameters& table, int& starts, std::string what);

}  // namespace rectilin
