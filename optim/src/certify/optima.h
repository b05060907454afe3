// Finds all frames that are as good as the best one.
#pragma once

#include <vector>

#include "rectilin/optim/certify.h"

namespace rectilin::certification {

/// Sets of frames (up to frame_symmetries()) whose values may be at most `threshold`, best first. Together they hold
/// every such frame, unless the budget ends first: frames elsewhere are excluded by the bound of their cell.
std::vector<Optimum> find_optima(Evaluator& evaluator, const CertifyOptions& options, double threshold);

}  // namespace rectilin::certification
