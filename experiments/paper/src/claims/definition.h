// The paper's definition taken word by word, to hold the fast code against.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

using EulerConvention = Rotation (*)(double alpha, double beta, double gamma);

/// The frame turned about its x axis by alpha, then about its y axis by beta, then about its z axis
/// by gamma, as a product of three matrices (section 3, before eq. 2).
Rotation frame_turned(double alpha, double beta, double gamma);

/// Eqs. (3)-(7), (11): P/S of the mesh against rotated vertices and cross products, face by
/// face.
Finding check_definition(const TestMesh& tested, Random random, EulerConvention convention);

/// Eqs. (35)-(37) against frame_turned(): margin minus the largest difference of two entries.
Finding check_convention(Random random, EulerConvention convention);

/// Eq. (22): P/S of the mesh against the angles between normals and axes.
Finding check_angles(const TestMesh& tested, Random random);

}  // namespace rectilin::paper::claims
