// Meshes in known positions, for tests of poses.
#pragma once

#include <numbers>
#include <string>

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/pose/pose.h"
#include "support/random_meshes.h"

namespace rectilin::test {

inline constexpr double kDegree = std::numbers::pi / 180;

inline Mesh shape(const std::string& spec) { return make_shape(Spec::parse(spec)); }

inline Mesh moved(const Mesh& mesh, const Rotation& turn, double scale = 1, const Vector3& by = Vector3::Zero()) {
  return transformed(mesh, [&](const Vector3& v) { return Vector3(scale * (turn.matrix() * v) + by); });
}

/// Two meshes as one.
inline Mesh together(Mesh a, const Mesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

/// An L of three lengths: no symmetry but one mirror plane, across z; and a pose that is plain to see.
inline Mesh bracket() {
  return together(shape("box?x=3&y=0.4&z=1"), moved(shape("box?x=0.5&y=2&z=0.7"), Rotation(), 1, {1.1, 1.2, 0}));
}

inline pose::Pose pose_of(const std::string& method, const Mesh& mesh) {
  return pose::pose_methods().make(method)(mesh);
}

}  // namespace rectilin::test
