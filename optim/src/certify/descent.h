// A local search that converges to kinks, where the minima are.
#pragma once

#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// Kelley's cutting plane method (1960) on rotations near the best one so far, in a cube of turns whose size adapts:
/// the minimum of the largest of the cuts is the next rotation. Where faces are parallel to axes at the minimum the
/// model becomes exact, so the search ends there after few steps.
///
/// Starts at `start`, whose cut is `cut`, with turns of at most `radius` about each axis (radians); takes at most
/// `steps` cuts, and stops when the model promises a gain of less than `enough`. Returns the best rotation of this
/// search.
Incumbent descend(Evaluator& evaluator, const Rotation& start, const Cut& cut, int steps, double radius, double enough);

inline constexpr double kWideSearch = 0.1;  ///< a radius for starts from which the minimum may be far

}  // namespace rectilin::certification
