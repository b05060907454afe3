// Principal axes: of the surface, of the vertices, of the normals.
#include <Eigen/Eigenvalues>

#include "frames.h"
#include "methods.h"

namespace rectilin::pose {
namespace {

/// Eigenvalues nearer to each other than this, relative to the largest, do not tell their axes apart: rounding of the
/// sums turns axes by about 1e-15 over the difference.
constexpr double kEqualValues = 1e-9;

}  // namespace

Pose principal_axes(const Eigen::Matrix3d& moments, const std::string& name) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  Eigen::Matrix3d rows;
  for (int k = 0; k < 3; ++k) rows.row(k) = solver.eigenvectors().col(2 - k).transpose();
  Pose pose = single(name, frame_of(rows));
  const Eigen::Vector3d values = solver.eigenvalues().reverse();
  const bool first = values[0] - values[1] <= kEqualValues * values[0],
             last = values[1] - values[2] <= kEqualValues * values[0];
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
