#include "features/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace rectilin::retrieval {

SurfaceSampler::SurfaceSampler(const Mesh& mesh) : mesh_(mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3& a = mesh.vertices[t[0]];
    const Vector3 cross = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    const double twice = cross.norm();
    sum += twice;
    upto_.push_back(sum);
    normals_.push_back(twice > 0 ? Vector3(cross / twice) : Vector3::Zero());
  }
  if (!(sum > 0) || !std::isfinite(sum)) throw MeshError("its surface has no area");
  for (double& share : upto_) share /= sum;
}

SurfacePoint SurfaceSampler::at(double u, double s, double t) const {
  auto i = static_cast<std::size_t>(std::ranges::upper_bound(upto_, u) - upto_.begin());
  i = std::min(i, upto_.size() - 1);
  const Triangle& triangle = mesh_.triangles[i];
  const double root = std::sqrt(s);  // Turk 1990: the square root makes up for the triangle's narrow end
  const Vector3 position = (1 - root) * mesh_.vertices[triangle[0]] + root * (1 - t) * mesh_.vertices[triangle[1]] +
                           root * t * mesh_.vertices[triangle[2]];
  return {position, static_cast<std::uint32_t>(i)};
}

}  // namespace rectilin::retrieval
