// Uniformly random rotations.
#include "rectilin/optim/allowance.h"
#include "rectilin/optim/registry.h"
#include "search/sampling.h"

namespace rectilin {
namespace {

/// Uniformly random rotations: the yardstick that every other optimizer has to beat.
struct RandomSearchOptions {
  int evaluations = 0;
  void bind(Parameters& table);
};

void RandomSearchOptions::bind(Parameters& table) { Allowance::bind(table, evaluations); }

void random_search(const RandomSearchOptions& options, Evaluator& evaluator, const Domain&, Random& random) {
  const Allowance allowance(evaluator, options.evaluations);
  evaluate_all(evaluator, allowance.remaining(), [&](std::uint64_t) { return random_rotation(random); });
}

}  // namespace

void add_random_search(Registry& registry) {
  registry.add(GlobalMethod<RandomSearchOptions>{.name = "random",
                                                 .help = "uniformly random rotations",
                                                 .capabilities = {.uses_domain = false, .batches = true},
                                                 .run = random_search});
}

}  // namespace rectilin
