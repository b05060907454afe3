// Random inputs for property tests.
#pragma once

#include <vector>

#include "rectilin/base/random.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::test {

inline Vector3 random_vector(Random& random) { return {random.normal(), random.normal(), random.normal()}; }

/// `triangles` triangles over a third as many shared vertices, with sizes over two orders of magnitude.
inline Mesh random_mesh(Random& random, int triangles) {
  Mesh mesh;
  const int vertices = 3 + triangles / 3;
  for (int i = 0; i < vertices; ++i)
    mesh.vertices.push_back(random_vector(random) * std::pow(10.0, random.uniform(-1, 1)));
  while (static_cast<int>(mesh.triangles.size()) < triangles) {
    const auto pick = [&] { return static_cast<std::uint32_t>(random.below(vertices)); };
    const Triangle t{pick(), pick(), pick()};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  return mesh;
}

template <class Map>
Mesh transformed(Mesh mesh, Map map) {
  for (Vector3& v : mesh.vertices) v = map(v);
  return mesh;
}

}  // namespace rectilin::test
