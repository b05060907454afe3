// What tests of comparisons share: optimizers with known ends, results made by hand.
#pragma once

#include "rectilin/laboratory/results.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "support/scratch_folder.h"

namespace rectilin::test {

struct NoOptions {
  void bind(Parameters&) {}
};

/// Proves what is known of the built-in box and pyramid: the pose they are made in is the best one.
inline void known_optimum(const NoOptions&, Evaluator& evaluator, const Domain&, Random&) {
  evaluator.raise_lower_bound(evaluator.value(Rotation()) * (1 - 1e-11));
}

/// Throws after a few evaluations.
inline void crash(const NoOptions&, Evaluator& evaluator, const Domain&, Random& random) {
  for (int i = 0; i < 3; ++i) evaluator.value(random_rotation(random));
  throw std::runtime_error("it <crashed>");
}

inline Registry test_registry() {
  Registry registry = all_optimizers();
  registry.add(GlobalMethod<NoOptions>{.name = "known",
                                       .help = "",
                                       .capabilities = {.uses_domain = false, .uses_random = false, .certifies = true},
                                       .run = known_optimum});
  registry.add(
      GlobalMethod<NoOptions>{.name = "crash", .help = "", .capabilities = {.uses_domain = false}, .run = crash});
  return registry;
}

/// A run that had the gaps `gap` after `evaluations`, and ended after `spent`.
inline laboratory::RunResult run_with(std::size_t mesh, std::size_t entry, int index, std::vector<double> evaluations,
                                      std::vector<double> gap, double spent) {
  laboratory::RunResult run;
  run.mesh = mesh;
  run.entry = entry;
  run.run = index;
  run.evaluations = spent;
  run.trace.worst = 1.25;
  run.trace.seconds = evaluations;
  run.trace.evaluations = std::move(evaluations);
  run.trace.gap = std::move(gap);
  run.record = {{"values", spent}, {"cuts", 0}, {"smooths", 0}, {"turns", 0}};
  return run;
}

inline laboratory::MeshResult mesh_with(const std::string& name, double lower, double upper) {
  laboratory::MeshResult mesh;
  mesh.name = mesh.title = name;
  mesh.lower = lower;
  mesh.upper = upper;
  return mesh;
}

}  // namespace rectilin::test
