// A finer mesh of the same surface.
#pragma once

#include <cstdint>

#include "rectilin/mesh/mesh.h"

namespace rectilin::test {

/// Each triangle in four.
inline Mesh subdivided(const Mesh& mesh) {
  Mesh fine;
  for (const Triangle& t : mesh.triangles) {
    const Vector3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const auto k = static_cast<std::uint32_t>(fine.vertices.size());
    for (const Vector3& v : {a, b, c, Vector3((a + b) / 2), Vector3((b + c) / 2), Vector3((c + a) / 2)})
      fine.vertices.push_back(v);
    for (const auto& s : {Triangle{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
      fine.triangles.push_back({k + s[0], k + s[1], k + s[2]});
  }
  return fine;
}

}  // namespace rectilin::test
