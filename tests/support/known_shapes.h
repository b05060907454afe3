// Meshes with a known answer, for tests of optimizers that need cuts, turns or the smooth
// surrogate.
#pragma once

#include <cmath>

#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::test {

/// R of a square pyramid as high as its base is wide.
inline const double kPyramid = 0.75 * (1 + std::sqrt(5.0)) - 2;

/// That pyramid in a pose that no domain's node or centre hits.
inline const ProjectedArea& pyramid() {
  static const ProjectedArea objective(area_vectors(make_shape(Spec::parse("pyramid?rotate=random&seed=5"))));
  return objective;
}

inline RunRecord run_on_pyramid(const std::string& spec, std::uint64_t seed = 1, Budget budget = {},
                                const Domain& domain = covering_domain()) {
  return run_optimizer(*all_optimizers().make(spec), pyramid(), {.budget = budget, .seed = seed, .domain = &domain});
}

}  // namespace rectilin::test
