// Section 5.2: what R is robust to, and how much of it.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// If the area vectors change by eta S in total, eta < 1, then R changes by at most r_change_bound(eta). Tested with
/// faint noise on the mesh and with a few holes in it; the margin is the bound less the certified change.
Finding check_stability(const TestMesh& tested, Random random);

/// Noise of 0.2 % of the extent on a box of 20,000 faces. The margin is 0.1 less the change of R.
std::vector<Finding> check_noise_on_fine_box(Random random);

/// The standard error of R, at the mesh's best rotation, if a share `kept` of its faces, chosen at random, remains:
/// that of the ratio P/S in a sample without replacement, to first order.
double deletion_error(const TestMesh& tested, double kept);

/// "Less than 0.005 at 90 %", on meshes where that is eight standard errors or more.
std::optional<Finding> check_deletion(const TestMesh& tested, Random random);
std::vector<Finding> check_deletion_on_large_shapes(Random random);
/// On any mesh of which enough remains for statistics: the change is less than eight standard errors.
std::optional<Finding> check_deletion_law(const TestMesh& tested, Random random);
/// "Less than 0.005 at 90 %", on a mesh with about as many faces as the paper's teapot.
std::vector<Finding> check_deletion_on_small_shape(Random random);

/// Smooth shapes that are simplified to a tenth of their faces keep R to within 0.01.
std::vector<Finding> check_simplification(Random random);

}  // namespace rectilin::paper::claims
