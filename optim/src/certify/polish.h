// The exact frame at the end of a search: solves for it instead of searching on.
#pragma once

#include "rectilin/optim/evaluator.h"

namespace rectilin::certification {

/// At a minimum faces are parallel to axes, r_k . v = 0, and as a rule three such conditions determine the frame. This
/// finds the conditions near the evaluator's incumbent, solves them by Newton's method to rounding level, and has the
/// evaluator try the frame, which becomes the incumbent if it is better.
void polish(Evaluator& evaluator);

}  // namespace rectilin::certification
