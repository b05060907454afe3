#include "shapes/compact_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "rectilin/mesh/edits.h"

namespace rectilin::serve {
namespace {

static_assert(std::endian::native == std::endian::little, "compact meshes are copied as they lie in memory");

constexpr std::size_t kMostSent = 2'000'000;  // triangles of a soup, which cannot be simplified
constexpr std::size_t kHeader = 16;
constexpr double kUnit = 32767;

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace

std::string compact_mesh(const Mesh& mesh) {
  const std::size_t original = mesh.triangles.size();
  const Mesh shown = original > kMostShown ? simplified(mesh, kMostShown) : mesh;
  if (shown.triangles.size() > kMostSent)
    throw MeshError("too many loose triangles to be shown: " + std::to_string(shown.triangles.size()));
  constexpr auto kUnused = ~std::uint32_t{0};
  std::vector<std::uint32_t> place(shown.vertices.size(), kUnused);
  std::vector<std::uint32_t> used;
  for (const Triangle& t : shown.triangles)
    for (const std::uint32_t v : t)
      if (place[v] == kUnused) {
        place[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(v);
      }
  std::string bytes = "RMSH";
  append(bytes, static_cast<std::uint32_t>(used.size()));
  append(bytes, static_cast<std::uint32_t>(std::min<std::size_t>(original, kUnused)));
  append(bytes, static_cast<std::uint32_t>(shown.triangles.size()));
  for (const Triangle& t : shown.triangles)
    for (const std::uint32_t v : t) append(bytes, place[v]);
  for (const std::uint32_t v : used)
    for (int k = 0; k < 3; ++k)
      append(bytes, static_cast<std::int16_t>(std::lround(std::clamp(shown.vertices[v](k), -1.0, 1.0) * kUnit)));
  return bytes;
}

Mesh mesh_of_compact(std::string_view bytes) {
  const auto wrong = [] { return MeshError("not a compact mesh"); };
  if (bytes.size() < kHeader || !bytes.starts_with("RMSH")) throw wrong();
  const std::size_t vertices = number_at<std::uint32_t>(bytes, 4), triangles = number_at<std::uint32_t>(bytes, 12);
  if (bytes.size() != kHeader + 12 * triangles + 6 * vertices) throw wrong();
  Mesh mesh;
  mesh.triangles.resize(triangles);
  mesh.vertices.resize(vertices);
  std::size_t at = kHeader;
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) {
      v = number_at<std::uint32_t>(bytes, at);
      if (v >= vertices) throw wrong();
      at += 4;
    }
  for (Vector3& p : mesh.vertices)
    for (int k = 0; k < 3; ++k, at += 2) p(k) = number_at<std::int16_t>(bytes, at) / kUnit;
  return mesh;
}

}  // namespace rectilin::serve
