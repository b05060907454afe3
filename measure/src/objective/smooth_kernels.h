// What the smooth surrogate (smooth.cpp) asks of its vector loop (smooth_kernels.cpp).
#pragma once

#include <Eigen/Core>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// Sums over some faces: of sqrt((r_k . v)^2 + e^2) over the rows r_k of a frame, with e = width
/// |v|, and of their derivatives by the entries of the frame.
struct SmoothSums {
  double value = 0;
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
};

/// On the best instruction set that is present and not ruled out by ScopedInstructionSet.
SmoothSums smooth_sums(const FaceSpan<double>& faces, const Eigen::Matrix3d& frame, double width);

}  // namespace rectilin
