// The appendix: P/S is not constant, because it is strictly concave between kinks.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// Lemma 1: the greatest P/S among random rotations exceeds the least one.
Finding check_not_constant(const TestMesh& tested, Random random);

/// Eq. (41) without taking a limit. While no face becomes parallel to axis 1 or 2 of a frame that
/// turns about its third axis, P(gamma) = h(r3) + a cos(gamma - gamma0). So in an interval without
/// kinks
///     P(gamma + s) + P(gamma - s) - 2 P(gamma) = -2 (1 - cos s) (P(gamma) - h(r3)),
/// which is negative, and over s^2 tends to eq. (41)'s second derivative -(P_YOZ + P_ZOX). The
/// function is the difference of the two sides, in units of S; infinite if the right one is not
/// negative.
double second_difference_error(const ProjectedArea& objective, const Rotation& middle, double step);
Finding check_second_difference(const TestMesh& tested, Random random);

}  // namespace rectilin::paper::claims
