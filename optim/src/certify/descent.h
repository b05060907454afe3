// A local search that ends on the kinks.
#pragma once

#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// Kelley's cutting plane method (1960) on rotations near the present best, in a cube of turns whose size adapts:
/// the minimum of the greatest cuts is the next rotation. Where faces are parallel to axes at the minimum, its
/// model becomes exact, and the search ends there after few steps.
///
/// Starts at `start` with its cut, takes at most `steps` cuts and stops when the model promises less than
/// `enough`. Returns the best rotation of this search.
Incumbent descend(Evaluator& evaluator, const Rotation& start, const Cut& cut, int steps, double enough);

}  // namespace rectilin::certification
