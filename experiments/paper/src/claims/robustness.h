// Section 5.2: what R withstands, and how much of it.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// If area vectors change by eta S in total, eta < 1, R changes by at most r_change_bound(eta): for
/// faint noise on the mesh, and for a few holes in it. Margin: the bound less the certified change.
Finding check_stability(const TestMesh& tested, Random random);

/// Noise of 0.2 % of the extent on a box of 20,000 faces: 0.1 minus the change of R.
std::vector<Finding> check_noise_on_fine_box(Random random);

/// Standard error of R, at the mesh's best rotation, when a share `kept` of its faces remains,
/// chosen at random: that of the ratio P/S of a sample without replacement, to first order.
double deletion_error(const TestMesh& tested, double kept);

/// "Less than 0.005 at 90 %", on meshes for which that is eight standard errors.
std::optional<Finding> check_deletion(const TestMesh& tested, Random random);
std::vector<Finding> check_deletion_on_large_shapes(Random random);
/// On any mesh from which enough remains for statistics: less than eight standard errors.
std::optional<Finding> check_deletion_law(const TestMesh& tested, Random random);
/// "Less than 0.005 at 90 %" on a mesh of about as many faces as the paper's teapot.
std::vector<Finding> check_deletion_on_small_shape(Random random);

/// Simplified to a tenth of their faces, smooth shapes keep R to within 0.01.
std::vector<Finding> check_simplification(Random random);

}  // namespace rectilin::paper::claims
