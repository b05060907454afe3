// Local methods: searches that improve one given start.
#pragma once

#include "rectilin/optim/optimizer.h"

namespace rectilin {

/// What a local optimizer offers in addition to run(): a descent from a start that the caller chooses. Thread safe like
/// the optimizer that it belongs to.
class LocalSearch {
 public:
  virtual ~LocalSearch() = default;

  /// Searches from `start` until the method has converged (which does not prove a minimum) or the budget is spent.
  virtual void improve(const Rotation& start, Evaluator& evaluator, const Domain& domain, Random& random) const = 0;
};

/// Where a local method starts if the caller does not say: at the evaluator's incumbent or, if there is none, at a
/// random rotation.
Rotation start_of(const Evaluator& evaluator, Random& random);

/// Runs `local` from `starts` uniformly random rotations. If `starts` is 0 it goes on until the budget is spent, or for
/// 10,000 evaluations if the budget has no limit. With `from_incumbent` the first start is start_of() instead.
void improve_from_starts(const LocalSearch& local, int starts, bool from_incumbent, Evaluator& evaluator,
                         const Domain& domain, Random& random);

/// Declares the setting `starts` that improve_from_starts() takes; `what` describes the starts in its help.
void bind_starts(Parameters& table, int& starts, std::string what);

}  // namespace rectilin
