#pragma once

#include "rectilin/optim/registry.h"

namespace rectilin {

/// Adds `nlopt:ALGORITHM` for the algorithms of NLopt (Johnson, nlopt.readthedocs.io) that fit a
/// box without constraints. They search the chart's box; those that want gradients get the smooth
/// surrogate's, and the objective itself is asked for at the end of each round.
void add_nlopt(Registry& registry);

}  // namespace rectilin
