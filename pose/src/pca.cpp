// Principal axes: of the surface, of the vertices, of the normals.

#include "frames.h"
#include "methods.h"
#include "rectilin/base/symmetric.h"

namespace rectilin::pose {
namespace {

/// Two moments that differ by less, relative to the larger, do not say which way their axes point: the tessellation of
/// a sphere or a cone may have decided. As in unroundness().
constexpr double kCloseMoments = 0.02;

bool close_moments(double larger, double smaller) { return larger - smaller <= kCloseMoments * larger; }

}  // namespace

Pose principal_axes(const Eigen::Matrix3d& moments, const std::string& name) {
  const SymmetricEigen eigen = symmetric_eigen(moments);
  Eigen::Matrix3d rows;
  for (int k = 0; k < 3; ++k) rows.row(k) = eigen.vectors.col(2 - k).transpose();
  Pose pose = single(name, frame_of(rows));
  const Eigen::Vector3d values = eigen.values.reverse();
  const bool first = close_moments(values[0], values[1]), last = close_moments(values[1], values[2]);
  pose.reason = "moments in the ratio 1 : " + std::to_string(values[1] / values[0]) + " : " +
                std::to_string(std::max(values[2], 0.0) / values[0]);
  if (first && last) pose.uniqueness = Uniqueness::kNone;
  else if (first || last) pose.uniqueness = Uniqueness::kContinuum, pose.free_axis = first ? 2 : 0;
  return pose;
}

Pose pca_pose(const Surface& surface) { return principal_axes(surface.moments, "pca"); }

Pose vertex_pca_pose(const Surface& surface) {
  const auto& vertices = surface.mesh.vertices;
  Vector3 mean = Vector3::Zero();
  for (const Vector3& v : vertices) mean += v / static_cast<double>(vertices.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vector3& v : vertices) moments += (v - mean) * (v - mean).transpose();
  return principal_axes(moments, "vertex-pca");
}

Pose normal_pca_pose(const Surface& surface) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < surface.areas.size(); ++i)
    moments += surface.areas[i] * surface.normals[i] * surface.normals[i].transpose();
  return principal_axes(moments, "normal-pca");
}

}  // namespace rectilin::pose
