// The interface between the smooth surrogate (smooth.cpp) and its vector loop (smooth_kernels.cpp).
#pragma once

#include <Eigen/Core>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// Sums over some area vectors v: of sqrt((r_k . v)^2 + e^2) over the rows r_k of a frame, with e = width |v|, and of
/// the derivatives with respect to the entries of the frame.
/// |v|, and of their derivatives by the entries of the frame.
struct SmoothSums {
  double value = 0;
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
};

/// Uses the best instruction set of the processor that ScopedInstructionSet allows.
SmoothSums smooth_sums(const VectorSpan<double>& faces, const Eigen::Matrix3d& frame, double width);

}  // namespace rectilin
