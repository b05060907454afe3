// The loops over generators, compiled once for each instruction set.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "certify/spherical_triangle.h"

namespace rectilin::certification {

/// Numbers of generators are rounded up to a multiple of this; zeros fill the rest.
inline constexpr std::size_t kGeneratorLanes = 8;

struct GeneratorSpan {
  const double *x, *y, *z;
  std::size_t size;  // rounded up
};

struct GeneratorOutput {
  double *x, *y, *z;  // room for everything that is read, and kGeneratorLanes more
};

/// sum sign(u . v_i) v_i
Eigen::Vector3d signed_sum(const GeneratorSpan& generators, const Eigen::Vector3d& u);

/// Copies those whose products with the corners differ in sign, counts them, and adds the signed sum of the others to
/// `settled`.
std::size_t copy_unsettled(const GeneratorSpan& generators, const Triangle3& corners, const GeneratorOutput& out,
                           Eigen::Vector3d& settled);

}  // namespace rectilin::certification
