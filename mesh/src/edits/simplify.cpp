#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "rectilin/mesh/edits.h"

namespace rectilin {
namespace {

/// The vertices in single precision, relative to the first one and in units of the longest side of the bounding box.
std::vector<float> positions(const Mesh& mesh) {
  const double extent = largest_extent(mesh), scale = extent > 0 ? 1 / extent : 1;
  std::vector<float> result;
  for (const Vector3& p : mesh.vertices)
    for (const double x : (p - mesh.vertices.front()) * scale)
      result.push_back(static_cast<float>(x) + 0.0f);  // + 0 turns -0 into 0: vertices are compared byte by byte
  return result;
}

constexpr std::size_t kStride = 3 * sizeof(float);

/// The mesh with only the vertices that triangles use, where vertices at the same position in single precision are one.
Mesh welded(const Mesh& mesh) {
  const std::vector<float> points = positions(mesh);
  std::vector<unsigned> corners;
  for (const Triangle& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  std::vector<unsigned> place(mesh.vertices.size());
  Mesh result;
  result.vertices.resize(
      meshopt_generateVertexRemap(place.data(), corners.data(), corners.size(), points.data(), place.size(), kStride));
  for (std::size_t i = place.size(); i-- > 0;)  // backwards, so that the first of several vertices is kept
    if (place[i] < result.vertices.size()) result.vertices[place[i]] = mesh.vertices[i];
  for (const Triangle& t : mesh.triangles) result.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
  std::erase_if(result.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return result;
}

}  // namespace

Mesh simplified(const Mesh& mesh, std::size_t faces) {
  if (mesh.triangles.size() <= faces) return mesh;
  Mesh result = welded(mesh);
  if (result.triangles.size() <= faces) return result;
  constexpr float kAnyError = std::numeric_limits<float>::max();
  const std::vector<float> points = positions(result);
  std::vector<unsigned> corners;
  for (const Triangle& t : result.triangles) corners.insert(corners.end(), t.begin(), t.end());
  std::vector<unsigned> left(corners.size());
  left.resize(meshopt_simplify(left.data(), corners.data(), corners.size(), points.data(), result.vertices.size(),
                               kStride, 3 * std::max<std::size_t>(faces, 1), kAnyError, 0, nullptr));
  result.triangles.clear();
  for (std::size_t i = 0; i < left.size(); i += 3) result.triangles.push_back({left[i], left[i + 1], left[i + 2]});
  return result;
}

}  // namespace rectilin
