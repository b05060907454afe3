#include "search/random_search.h"

#include "rectilin/optim/allowance.h"
#include "search/sampling.h"

namespace rectilin {

void RandomSearchOptions::bind(Parameters& table) { Allowance::bind(table, evaluations); }

void RandomSearch::run(Evaluator& evaluator, const Domain&, Random& random) const {
  const Allowance allowance(evaluator, options_.evaluations);
  evaluate_all(evaluator, allowance.remaining(), [&](std::uint64_t) { return random_rotation(random); });
}

}  // namespace rectilin
