#include "rectilin/search/same_pose.h"

#include <Eigen/LU>
#include <cmath>

#include "alignment.h"

namespace rectilin::search {
namespace {

constexpr double kNearlyOne = 0.05;  // radii: fits nearer than this are no accident

/// The rotation of a matrix that turns and scales.
Eigen::Matrix3d turn_of(const Eigen::Matrix3d& linear) { return linear / std::cbrt(linear.determinant()); }

}  // namespace

SamePose same_pose(const Mesh& first, const Mesh& second) {
  const AlignedShape a{retrieval::Model(first)}, b{retrieval::Model(second)};
  const Fit free = best_fit(a, b, false);
  const Fit fit = free.distance < kNearlyOne ? free : best_frame(a, b);
  return {a.principal().transpose() * turn_of(fit.linear) * b.principal(), fit.distance};
}

}  // namespace rectilin::search
