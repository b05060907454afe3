// The simplex method of Nelder and Mead.
#include "rectilin/optim/registry.h"
#include "search/simplex.h"

namespace rectilin {
namespace {

/// Nelder and Mead (1965) on rotations, see simplex.h. At kinks a simplex may become flat and stop short of a minimum.
/// A new simplex where it stopped shows whether it did (Kelley 1999); papers/optimizers.md says how often that happens.
struct NelderMeadOptions {
  double size = 0.3;
  double tolerance = 1e-9;
  int restarts = 1;
  void bind(Parameters& table);
};

void NelderMeadOptions::bind(Parameters& table) {
  table.real("size", size, 1e-12, 1.5, "edge of the first simplex (radians)")
      .real("tolerance", tolerance, 1e-15, 1, "a simplex smaller than this (radians) has converged")
      .integer("restarts", restarts, 0, 1000000,
               "further simplices at the point of convergence, each a tenth as large as the one before");
}

void nelder_mead(const NelderMeadOptions& options, const Rotation& start, Evaluator& evaluator, const Domain&,
                 Random& random) {
  Rotation at = start;
  double size = options.size;
  for (int round = 0; round <= options.restarts && !evaluator.exhausted(); ++round, size /= 10) {
    Simplex simplex = Simplex::around(at, size, evaluator, random);
    while (simplex.radius() > options.tolerance && !evaluator.exhausted()) simplex.step(evaluator);
    at = simplex.best().rotation;
  }
}

}  // namespace

void add_nelder_mead(Registry& registry) {
  registry.add(LocalMethod<NelderMeadOptions>{.name = "nelder-mead",
                                              .help = "Nelder and Mead's simplex method on rotations; local",
                                              .capabilities = {.uses_domain = false},
                                              .improve = nelder_mead});
}

}  // namespace rectilin
