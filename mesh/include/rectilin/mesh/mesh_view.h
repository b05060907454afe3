// A triangle mesh where it lies: in a Mesh, or in arrays of somebody else.
#pragma once

#include <span>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Looks at a mesh without owning or copying it; what it looks at must outlive it. Mesh's invariants hold: every index
/// is below vertices.size(), every coordinate is finite. A Mesh converts to it, so functions that only look take one.
struct MeshView {
  std::span<const Vector3> vertices;
  std::span<const Triangle> triangles;

  MeshView(const Mesh& mesh) : vertices(mesh.vertices), triangles(mesh.triangles) {}  // meant to be implicit
  MeshView(std::span<const Vector3> vertices_, std::span<const Triangle> triangles_)
      : vertices(vertices_), triangles(triangles_) {}
};

}  // namespace rectilin
