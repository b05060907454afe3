// Adds the optimizers of other libraries: NLopt, Ceres and pagmo.
#pragma once

#include "rectilin/base/json_fwd.h"
#include "rectilin/optim/registry.h"

namespace rectilin {

/// The built-in optimizers, followed by those of Ceres, NLopt and pagmo where this build includes these libraries.
const Registry& all_optimizers();

/// Names and versions of those libraries, such as {"NLopt": "2.7.1"}.
Json optimizer_libraries();

/// Adds `ceres`: L-BFGS with line searches (Ceres: Agarwal, Mierle and others) on the manifold of unit quaternions. It
/// minimises the smooth surrogate, with less and less smoothing. Available if the build has RECTILIN_CERES.
void add_ceres(Registry& registry);

/// Adds `nlopt:ALGORITHM` for the algorithms of NLopt (Johnson, nlopt.readthedocs.io) that search a box without further
/// constraints. They search the domain's box. Those that want gradients work on the smooth surrogate, and the objective
/// itself is evaluated at the end of each round. Available if the build has RECTILIN_NLOPT.
void add_nlopt(Registry& registry);

/// Adds `pagmo:ALGORITHM` for the single-objective algorithms of pagmo 2 (Biscani and Izzo 2020). They search the
/// domain's box; the incumbent, if there is one, joins the first population. Available if the build has RECTILIN_PAGMO
/// and found the library.
void add_pagmo(Registry& registry);

}  // namespace rectilin
