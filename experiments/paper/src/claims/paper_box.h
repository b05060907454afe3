// The least P/S on the paper's search box [0, pi/2]^3 (eq. 28), certified.
#pragma once

#include "claims/test_mesh.h"
#include "rectilin/optim/objective.h"

namespace rectilin::paper::claims {

/// Does the paper's box hold a frame equal to `rotation`'s, up to frame_symmetries()? Exactly where
/// an axis has the signs
/// (+,-,+) or (-,+,-), zeros allowed (papers/erratum.md).
bool in_paper_box(const Rotation& rotation);

/// Encloses the least value on the box to within `gap` of R, or as far as `cells` boxes go. Branch
/// and bound in the Euler angles: with a cut G taken at R0, B = R0 G^T, w the axial vector of B -
/// B^T, and lambda the least eigenvalue of its symmetric part, any rotation E R0 with E by an angle
/// of at most d <= pi/2 has
///     P >= P(R0) - sin d |w| - (1 - cos d) (P(R0) - lambda),
/// and the angle from a cell's centre to its points is at most sqrt((a + c)^2 + b^2) for half-edges
/// a, b, c.
Enclosure enclose_on_paper_box(const Objective& objective, double gap = 1e-6, int cells = 200'000);

}  // namespace rectilin::paper::claims
