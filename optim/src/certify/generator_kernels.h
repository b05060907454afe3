// The loops over generators, compiled once for each instruction set.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "certify/spherical_triangle.h"
#include "rectilin/optim/objective.h"

namespace rectilin::certification {

/// Numbers of generators are rounded up to a multiple of this; the rest is filled with zeros.
inline constexpr std::size_t kGeneratorLanes = 8;

struct GeneratorSpan {
  const double *x, *y, *z;
  std::size_t size;  // rounded up
};

struct GeneratorOutput {
  double *x, *y, *z;  // with room for all the input and kGeneratorLanes more
};

/// sum sign(u . v_i) v_i
Eigen::Vector3d signed_sum(const GeneratorSpan& generators, const Eigen::Vector3d& u);

/// Copies the generators whose products with the corners do not all have one sign, returns their number, and adds the
/// signed sum of the others to `settled`.
std::size_t copy_unsettled(const GeneratorSpan& generators, const Triangle3& corners, const GeneratorOutput& out,
                           Eigen::Vector3d& settled);

/// The generators near to being orthogonal to an axis of a frame, whose signs a small turn may change, and sums over
/// the others, whose signs it does not.
struct FrameSplit {
  std::vector<std::size_t> near;                           // indices, ascending
  std::array<Eigen::Matrix<long double, 3, 1>, 3> others;  // for each axis the sum of sign(r_k . v) v
  double total = 0;                                        // sum of all |v|
};

/// Near are those with |r_k . v| < sine |v| for an axis r_k. Sums have a relative error of at most 3e-13.
FrameSplit split_at(const Eigen::Matrix3d& frame, const Generators& generators, double sine);

}  // namespace rectilin::certification
