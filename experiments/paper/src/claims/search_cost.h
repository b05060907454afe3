// What the paper says about its genetic algorithm: when it is stable, and what it costs.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// How much R still rises after generation 150 of 200, in a run with the paper's parameters on the paper's box.
struct LateGain {
  double r = 0;       ///< the rise
  Rotation rotation;  ///< where the run ended
};
LateGain gain_after_150(const Objective& objective, std::uint64_t seed);

/// "Usually stable after about 150 generations": the margin is 10^-3 less that rise.
Finding check_stable(const TestMesh& tested, Random random);
/// The same for shapes in random poses, several runs each.
std::vector<Finding> check_stable_on_shapes(Random random);
/// Many runs on one shape: tests the stronger reading, that every run is stable.
std::vector<Finding> check_always_stable(Random random);

/// The cost is proportional to the number of faces: the number of evaluations does not depend on the mesh, and the
/// processor time of an evaluation divided by the number of faces grows by no more than kSlack while that number grows
/// by kRange.
std::vector<Finding> check_linear_cost(Random random);

}  // namespace rectilin::paper::claims
