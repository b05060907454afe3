// Certified bounds of the least P/S on the paper's search box [0, pi/2]^3 (eq. 28).
#pragma once

#include "claims/test_mesh.h"
#include "rectilin/optim/objective.h"

namespace rectilin::paper::claims {

/// Does the paper's box hold the frame of `rotation`, up to frame_symmetries()? It does exactly if one of the three
/// axes has the signs (+,-,+) or (-,+,-), where zero counts as either (papers/erratum.md).
bool in_paper_box(const Rotation& rotation);

/// Encloses the least value on the box until R is known to within `gap`, or until `cells` boxes have been used. Branch
/// and bound in the Euler angles. Let G be a cut taken at R0, B = R0 G^T, w the axial vector of B - B^T, and lambda
/// the least eigenvalue of the symmetric part of B. Then for a rotation E R0, where E turns by an angle of at most d
/// <= pi/2,
///     P >= P(R0) - sin d |w| - (1 - cos d) (P(R0) - lambda),
/// and the angle from the centre of a cell to its points is at most sqrt((a + c)^2 + b^2), for half-edges a, b, c.
Enclosure enclose_on_paper_box(const Objective& objective, double gap = 1e-6, int cells = 200'000);

}  // namespace rectilin::paper::claims
