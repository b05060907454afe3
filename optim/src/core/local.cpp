#include "rectilin/optim/local.h"

#include "rectilin/optim/allowance.h"

namespace rectilin {

Rotation start_of(const Evaluator& evaluator, Random& random) {
  return evaluator.has_incumbent() ? evaluator.incumbent().rotation : random_rotation(random);
}

void improve_from_starts(const LocalSearch& local, int starts, bool from_incumbent, Evaluator& evaluator,
                         const Domain& domain, Random& random) {
  const Allowance allowance(evaluator, 0);
  for (int i = 0; starts == 0 || i < starts; ++i) {
    const std::uint64_t before = evaluator.costs().evaluations();
    const Rotation start = i == 0 && from_incumbent ? start_of(evaluator, random) : random_rotation(random);
    local.improve(start, evaluator, domain, random);
    // The rest of the budget may be too small for a step of this method: without this check the loop would never end.
    const bool idle = evaluator.costs().evaluations() == before;
    if (idle || evaluator.exhausted() || (starts == 0 && allowance.spent())) return;
  }
}

void bind_starts(Parameters& table, int& starts, std::string what) {
  what += "; 0: until the budget is spent, or 10,000 evaluations if it has no limit";
  table.integer("starts", starts, 0, 1000000000, std::move(what));
}

}  // namespace rectilin
