#include "rectilin/pose/pose.h"

#include <algorithm>
#include <cmath>

#include "methods.h"

namespace rectilin::pose {

std::string to_string(Uniqueness uniqueness) {
  switch (uniqueness) {
    case Uniqueness::kUnique:
      return "unique";
    case Uniqueness::kSeveral:
      return "several";
    case Uniqueness::kContinuum:
      return "continuum";
    case Uniqueness::kNone:
      return "none";
  }
  return "";
}

Mesh normalized(const Mesh& mesh, const Pose& pose) {
  Mesh result = mesh;
  const Vector3 centre = pose.scale * pose.centre;
  for (Vector3& v : result.vertices) {
    v = pose.rotation.matrix() * (pose.scale * v - centre);
    if (!v.allFinite()) throw MeshError("a vertex that no face uses is too far away to be scaled with the others");
  }
  return result;
}

Pose single(std::string name, const Rotation& rotation) {
  Pose pose;
  pose.chosen = name;
  pose.rotation = rotation;
  pose.candidates.push_back({.name = std::move(name),
                             .rotation = rotation,
                             .silhouette = {},
                             .volume = {},
                             .mirror_defects = {},
                             .flat_share = {}});
  return pose;
}

void choose(Pose& pose, std::size_t index) {
  std::rotate(pose.candidates.begin(), pose.candidates.begin() + static_cast<std::ptrdiff_t>(index),
              pose.candidates.begin() + static_cast<std::ptrdiff_t>(index) + 1);
  pose.chosen = pose.candidates.front().name;
  pose.rotation = pose.candidates.front().rotation;
}

}  // namespace rectilin::pose
