// Theorem 1, and what it says of meshes that are nearly rectilinear.
//
// For a unit vector n at an angle t to the nearest axis, t <= acos(1/sqrt(3)),
//     kLeastSlope t <= |n|_1 - 1 <= sqrt(2) t.
// The right side is cos t + sin t (|cos| + |sin|) - 1 at its largest; the left one holds because
// cos t + sin t - 1 is concave, so it lies above its chord. Summed over faces weighted by area,
// with T the mean tilt of a mesh in a frame,
//     kLeastSlope T <= P/S - 1 <= sqrt(2) T,
// which at T = 0 is Theorem 1 and otherwise says how far from rectilinear a mesh is whose R is
// below 1.
#pragma once

#include "claims/tests.h"

namespace rectilin::paper::claims {

/// (cos t + sin t - 1) / t at t = acos(1/sqrt(3)).
extern const double kLeastSlope;

/// Mean angle between a face and the nearest plane of the frame, weighted by area. Radians.
double mean_tilt(const AreaVectors& vectors, const Rotation& frame);

/// The frame Definition 1 leaves no choice about in a rectilinear mesh: one axis along the normal
/// of the largest face, one along what is most nearly orthogonal to it.
Rotation frame_by_definition(const AreaVectors& vectors);

/// "If": in the frame by definition, 1 + sqrt(2) T is no less than the least P/S.
Finding check_rectilinear_gives_equality(const TestMesh& tested);
/// "Only if": at the best rotation T is no more than (P/S - 1) / kLeastSlope.
Finding check_equality_gives_rectilinear(const TestMesh& tested);

/// Theorem 3.2 by Definition 1's angles between pairs of normals and the certified R.
Finding check_one_iff_rectilinear(const TestMesh& tested);
/// Rectilinear shapes in random poses have R = 1; others have less.
std::vector<Finding> check_known_shapes(Random random);

/// A cube whose top is tilted by 10^-1 ... 10^-6: R falls by half the angle (closed_forms.h).
std::vector<Finding> check_tilted_top(Random random);

}  // namespace rectilin::paper::claims
