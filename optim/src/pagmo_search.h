#pragma once

#include "rectilin/optim/registry.h"

namespace rectilin {

/// Adds `pagmo:ALGORITHM` for the single-objective algorithms of pagmo 2 (Biscani and Izzo 2020);
/// nothing if the library was built without it. They search the chart's box; the incumbent, if
/// there is one, joins the first population.
void add_pagmo(Registry& registry);

}  // namespace rectilin
