// A mesh's surface area, summed plainly.
#pragma once

#include "rectilin/mesh/mesh.h"

namespace rectilin::test {

inline double surface(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  return sum;
}

}  // namespace rectilin::test
