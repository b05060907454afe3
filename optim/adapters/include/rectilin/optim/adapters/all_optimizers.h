// Optimizers of other libraries, and all optimizers of this build.
#pragma once

#include "rectilin/base/json_fwd.h"
#include "rectilin/optim/registry.h"

namespace rectilin {

/// The built-in optimizers, then those of Ceres, NLopt and pagmo, as far as this build has them.
const Registry& all_optimizers();

/// Names and versions of the libraries behind them, such as {"NLopt": "2.7.1"}.
Json optimizer_libraries();

/// Adds `ceres`: L-BFGS with line searches (Ceres: Agarwal, Mierle and others) on the manifold of unit quaternions,
/// minimising the smooth surrogate with ever less smoothing. There if the build has RECTILIN_CERES.
void add_ceres(Registry& registry);

/// Adds `nlopt:ALGORITHM` for the algorithms of NLopt (Johnson, nlopt.readthedocs.io) that fit a box without
/// constraints. They search the domain's box; those that want gradients get the smooth surrogate's, and the objective
/// itself is asked for at the end of each round. There if the build has RECTILIN_NLOPT.
void add_nlopt(Registry& registry);

/// Adds `pagmo:ALGORITHM` for the single-objective algorithms of pagmo 2 (Biscani and Izzo 2020). They search the
/// domain's box; the incumbent, if there is one, joins the first population. There if the build has RECTILIN_PAGMO and
/// found the library.
void add_pagmo(Registry& registry);

}  // namespace rectilin
