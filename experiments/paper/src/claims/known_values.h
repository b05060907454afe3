// Numbers printed in the paper.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Section 5.3: the pyramid's 0.4270.
std::vector<Finding> check_pyramid(Random random);

/// Fig. 15: stepped pyramids have R = 1 for any number of steps.
std::vector<Finding> check_stepped_pyramids(Random random);

/// The closed forms of closed_forms.h against certified bounds.
std::vector<Finding> check_closed_forms(Random random);

}  // namespace rectilin::paper::claims
