// The paper's definitions, implemented literally, as a check on the fast code.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

using EulerConvention = Rotation (*)(double alpha, double beta, double gamma);

/// The frame turned about its x axis by alpha, then about its y axis by beta, then about its z axis by gamma, as the
/// product of three matrices (section 3, before eq. 2).
Rotation frame_turned(double alpha, double beta, double gamma);

/// Eqs. (3)-(7), (11): compares P/S with a computation from rotated vertices and cross products, face by face.
Finding check_definition(const TestMesh& tested, Random random, EulerConvention convention);

/// Eqs. (35)-(37): compares them with frame_turned(). The margin is an allowance for rounding less the largest
/// difference of two entries.
Finding check_convention(Random random, EulerConvention convention);

/// Eq. (22): compares P/S with a computation from the angles between normals and axes.
Finding check_angles(const TestMesh& tested, Random random);

}  // namespace rectilin::paper::claims
