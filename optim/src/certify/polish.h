// The exact frame at the end: a few linear conditions solved instead of searched for.
#pragma once

#include <vector>

#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// A generator that is parallel to an axis of the frame: r_axis . v = 0.
struct ActiveGenerator {
  int axis;               ///< 0, 1 or 2
  std::size_t generator;  ///< index into Objective::generators()
};

/// At a minimum faces are parallel to axes, r_k . v = 0, and as a rule three such conditions fix the frame. Finds them
/// near the evaluator's incumbent, solves them by Newton's method to rounding level, and offers the frame to the
/// evaluator, which keeps it if it is better.
///
/// Returns the conditions that hold at the incumbent afterwards, an independent set: three, or fewer if fewer were
/// found, as on a surface of revolution.
std::vector<ActiveGenerator> polish(Evaluator& evaluator);

}  // namespace rectilin::certification
