#include "working_frame.h"

#include "methods.h"
#include "rectilin/base/symmetric.h"
#include "rectilin/pose/axes.h"

namespace rectilin::pose {
namespace {

/// Principal axes whose moments differ by less are too sensitive to rounding.
constexpr double kDistinctMoments = 1e-3;

}  // namespace

Rotation working_frame(const Surface& surface) {
  const Eigen::Vector3d values = symmetric_eigenvalues(surface.moments);
  const bool distinct = std::min(values[1] - values[0], values[2] - values[1]) > kDistinctMoments * values[2];
  const Rotation frame =
      distinct ? pca_pose(surface).rotation : rectilinear_pose(surface, {.cells = 20'000, .optima = false}).rotation;
  return resolve_axes(surface.mesh, frame, AxisRule::kDefinite).rotation;
}

Surface turned(const Surface& surface, const Rotation& rotation) {
  Surface result = surface;
  const Eigen::Matrix3d& r = rotation.matrix();
  for (Vector3& v : result.mesh.vertices) v = r * v;
  for (Vector3& n : result.normals) n = r * n;
  result.moments = r * surface.moments * r.transpose();
  return result;
}

Pose turned_back(Pose pose, const Rotation& rotation) {
  pose.rotation = pose.rotation * rotation;
  for (PoseCandidate& candidate : pose.candidates) candidate.rotation = candidate.rotation * rotation;
  for (Rotation& alternative : pose.alternatives) alternative = alternative * rotation;
  return pose;
}

}  // namespace rectilin::pose
