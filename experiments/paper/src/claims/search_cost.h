// What the paper says of its genetic algorithm: when it is stable, and what it costs.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// How much R rises after generation 150 of 200 in a run with the paper's parameters, on the
/// paper's box.
struct LateGain {
  double r = 0;       ///< the rise
  Rotation rotation;  ///< where the run ended
};
LateGain gain_after_150(const Objective& objective, std::uint64_t seed);

/// "Usually stable after about 150 generations": 10^-3 minus that gain.
Finding check_stable(const TestMesh& tested, Random random);
/// The same for shapes in random poses, some runs each.
std::vector<Finding> check_stable_on_shapes(Random random);
/// One shape, many runs: the reading in which every run is stable.
std::vector<Finding> check_always_stable(Random random);

/// Cost proportional to the number of faces: the evaluations of a run do not depend on the mesh,
/// and the processor time of one evaluation per face does not grow by more than kSlack over a range
/// of kRange in faces.
std::vector<Finding> check_linear_cost(Random random);

}  // namespace rectilin::paper::claims
