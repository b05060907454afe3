// Compares numbers printed in the paper with certified bounds.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Section 5.3: R = 0.4270 for the pyramid.
std::vector<Finding> check_pyramid(Random random);

/// Fig. 15: stepped pyramids have R = 1 for any number of steps.
std::vector<Finding> check_stepped_pyramids(Random random);

/// Compares the closed forms of closed_forms.h with certified bounds.
std::vector<Finding> check_closed_forms(Random random);

}  // namespace rectilin::paper::claims
