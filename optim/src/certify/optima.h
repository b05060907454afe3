// All frames that are as good as the best.
#pragma once

#include <vector>

#include "rectilin/optim/certify.h"

namespace rectilin::certification {

/// Classes of frames (up to frame_symmetries()) that may have a value of at most `threshold`, best first. Every such
/// frame is in one of them, unless the budget ends first; a frame elsewhere is excluded by its cell's bound.
std::vector<Optimum> find_optima(Evaluator& evaluator, const CertifyOptions& options, double threshold);

}  // namespace rectilin::certification
