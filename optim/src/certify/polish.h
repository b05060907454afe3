// The exact frame at the end of a search: solves for it instead of searching on.
#pragma once

#include <vector>

#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// A generator that is orthogonal to an axis of the frame, r_axis . v = 0: its face is parallel to that axis.
struct ActiveGenerator {
  int axis;               ///< 0, 1 or 2
  std::size_t generator;  ///< index into Objective::generators()
  bool operator==(const ActiveGenerator&) const = default;
};

/// At a minimum faces are parallel to axes, r_k . v = 0, and as a rule three such conditions determine the frame. This
/// finds the conditions near the evaluator's incumbent, solves them by Newton's method to rounding level, and has the
/// evaluator try the frame, which becomes the incumbent if it is better.
///
/// Returns an independent set of the conditions that hold at the incumbent afterwards: three, or fewer if no more were
/// found, as on a surface of revolution.
std::vector<ActiveGenerator> polish(Evaluator& evaluator);

}  // namespace rectilin::certification
