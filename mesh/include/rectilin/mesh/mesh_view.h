// A view of a triangle mesh: of a Mesh, or of arrays that somebody else owns.
#pragma once

#include <span>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Refers to a mesh without owning or copying it; the mesh must outlive the view. As for Mesh, every index must be
/// below vertices.size() and every coordinate finite. A Mesh converts to a view, so functions that only read a mesh
/// take one.
struct MeshView {
  std::span<const Vector3> vertices;
  std::span<const Triangle> triangles;

  MeshView(const Mesh& mesh) : vertices(mesh.vertices), triangles(mesh.triangles) {}  // implicit on purpose
  MeshView(std::span<const Vector3> vertices_, std::span<const Triangle> triangles_)
      : vertices(vertices_), triangles(triangles_) {}
};

}  // namespace rectilin
