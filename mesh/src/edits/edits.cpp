#include "rectilin/mesh/edits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rectilin {

double largest_extent(const Mesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  Vector3 lower = mesh.vertices.front(), upper = lower;
  for (const Vector3& p : mesh.vertices) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return (upper - lower).maxCoeff();
}

Mesh with_noise(Mesh mesh, double amount, Random random) {
  const double deviation = amount * largest_extent(mesh);
  for (Vector3& p : mesh.vertices)
    for (double& coordinate : p) coordinate += deviation * random.normal();
  return mesh;
}

Mesh without_faces(const Mesh& mesh, double fraction, Random random) {
  const std::size_t faces = mesh.triangles.size();
  if (faces == 0) return mesh;
  const auto wanted = static_cast<std::size_t>(std::llround(fraction * static_cast<double>(faces)));
  const std::size_t gone = std::min(wanted, faces - 1);
  std::vector<std::size_t> order(faces);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < gone; ++i)  // the first steps of a Fisher-Yates shuffle
    std::swap(order[i], order[i + random.below(faces - i)]);
  std::sort(order.begin() + static_cast<std::ptrdiff_t>(gone), order.end());
  Mesh rest{mesh.vertices, {}};
  for (std::size_t i = gone; i < faces; ++i) rest.triangles.push_back(mesh.triangles[order[i]]);
  return rest;
}

}  // namespace rectilin
