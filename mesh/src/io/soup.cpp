#include "io/soup.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "io/triangulate.h"

namespace rectilin {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A vertex under a number that equal positions share, so that sorting rarely looks at coordinates.
struct PositionKey {
  std::uint64_t hash;
  std::uint32_t vertex;
};

std::uint64_t hash_position(const Vector3& position) {
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    hash ^= std::bit_cast<std::uint64_t>(coordinate + 0.0);  // the sum makes one zero of two
    hash *= 0x9E3779B97F4A7C15u;                             // Knuth's multiplicative hashing
    hash ^= hash >> 32;
  }
  return hash;
}

// Sorts keys by `less`, which compares hashes first: they are dealt to buckets by their first bits, and buckets sorted,
// most of which hold a few keys. Whatever the hashes, it takes no longer than sorting alone.
template <class Less>
void sort_in_buckets(std::vector<PositionKey>& keys, const Less& less) {
  constexpr std::size_t kPerBucket = 4;
  const int bits = static_cast<int>(std::bit_width(keys.size() / kPerBucket));
  if (bits == 0) return std::sort(keys.begin(), keys.end(), less);
  const auto bucket = [&](const PositionKey& key) { return key.hash >> (64 - bits); };
  std::vector<std::uint32_t> ends((std::size_t{1} << bits) + 1, 0);
  for (const PositionKey& key : keys) ++ends[bucket(key) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<PositionKey> dealt(keys.size());
  for (const PositionKey& key : keys) dealt[ends[bucket(key)]++] = key;  // a bucket's begin becomes its end
  std::uint32_t begin = 0;
  for (const std::uint32_t end : ends) {
    if (end > begin + 1) std::sort(dealt.begin() + begin, dealt.begin() + end, less);
    begin = std::max(begin, end);
  }
  keys.swap(dealt);
}

// For each vertex the first one at its position; a vertex that is not finite stands for itself.
// Sorting, unlike a hash table, has no worst case that a file could aim at.
std::vector<std::uint32_t> first_at_position(const std::vector<Vector3>& vertices) {
  std::vector<std::uint32_t> first(vertices.size());
  std::vector<PositionKey> keys;
  keys.reserve(vertices.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    first[i] = i;
    if (vertices[i].allFinite()) keys.push_back({hash_position(vertices[i]), i});
  }
  sort_in_buckets(keys, [&](const PositionKey& a, const PositionKey& b) {
    if (a.hash != b.hash) return a.hash < b.hash;
    const Vector3 &p = vertices[a.vertex], &q = vertices[b.vertex];
    if (p.x() != q.x()) return p.x() < q.x();
    if (p.y() != q.y()) return p.y() < q.y();
    return p.z() != q.z() ? p.z() < q.z() : a.vertex < b.vertex;
  });
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const std::uint32_t vertex = keys[k].vertex, before = keys[k - 1].vertex;
    if (vertices[vertex] == vertices[before]) first[vertex] = first[before];
  }
  return first;
}

// Removes vertices that are not finite and, if asked to, welds equal ones. Returns for each old
// vertex its new index, or kNone.
std::vector<std::uint32_t> compact_vertices(PolygonSoup& soup, MeshReport& report) {
  const std::vector<std::uint32_t> first = first_at_position(soup.vertices);
  std::vector<std::uint32_t> target(soup.vertices.size(), kNone);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const bool duplicate = first[i] != i;
    if (duplicate && soup.weld) {
      target[i] = target[first[i]];
    } else if (!soup.vertices[i].allFinite()) {
      ++report.nonfinite_vertices;
    } else {
      report.duplicate_vertices += duplicate;
      soup.vertices[kept] = soup.vertices[i];
      target[i] = kept++;
    }
  }
  soup.vertices.resize(kept);
  return target;
}

// Triangulates all polygons that can be kept. `target` is where their vertices have gone.
std::vector<Triangle> triangulate_all(PolygonSoup& soup, const std::vector<std::uint32_t>& target, MeshReport& report,
                                      const std::string& name) {
  std::vector<Triangle> triangles;
  triangles.reserve(soup.ends.size());
  PolygonTriangulator triangulator;
  std::size_t begin = 0, number = 0;
  for (const std::size_t end : soup.ends) {
    ++number;
    const std::span polygon(soup.corners.data() + begin, end - begin);
    begin = end;
    for (std::uint32_t& corner : polygon) corner = target[corner];
    if (polygon.size() < 3) {
      ++report.dropped_short;
    } else if (std::find(polygon.begin(), polygon.end(), kNone) != polygon.end()) {
      ++report.dropped_nonfinite;
    } else {
      report.triangulated += polygon.size() > 3;
      if (!triangulator.append(soup.vertices, polygon, triangles))
        throw MeshError(name + ": polygon " + std::to_string(number) + " has " + std::to_string(polygon.size()) +
                        " corners and is too intricate to be cut into triangles");
    }
  }
  return triangles;
}

std::size_t count_unreferenced(const Mesh& mesh) {
  std::vector<char> used(mesh.vertices.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) used[corner] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
}

// Areas are taken at the scale of the triangles' bounding box, so that they vanish only where they
// are nothing against the mesh, whatever its unit of length.
std::size_t count_degenerate(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) box.extend(mesh.vertices[corner]);
  }
  const double scale = unit_scale(box);
  const auto is_degenerate = [&](const Triangle& triangle) {
    const Vector3 a = scale * mesh.vertices[triangle[0]];
    const Vector3 b = scale * mesh.vertices[triangle[1]] - a;
    const Vector3 c = scale * mesh.vertices[triangle[2]] - a;
    return b.cross(c).isZero(0.0);
  };
  return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), is_degenerate));
}

}  // namespace

LoadedMesh assemble(PolygonSoup soup, const std::string& name) {
  if (soup.ends.empty()) throw MeshError(name + ": no faces, so there is no surface to measure");
  if (soup.vertices.size() >= kNone) throw MeshError(name + ": more than 4294967294 vertices");

  LoadedMesh loaded;
  MeshReport& report = loaded.report;
  report = soup.report;
  report.vertices = soup.vertices.size();
  report.polygons = soup.ends.size();
  report.scene = soup.scene;
  const std::vector<std::uint32_t> target = compact_vertices(soup, report);
  loaded.mesh.triangles = triangulate_all(soup, target, report, name);
  loaded.mesh.vertices = std::move(soup.vertices);

  if (loaded.mesh.triangles.empty()) {
    throw MeshError(name + ": no triangle is left, every face has fewer than three corners or a " +
                    "coordinate that is not finite");
  }
  report.degenerate = count_degenerate(loaded.mesh);
  report.unreferenced_vertices = count_unreferenced(loaded.mesh);
  if (report.degenerate == loaded.mesh.triangles.size()) {
    throw MeshError(name + ": the total area is zero");
  }
  return loaded;
}

}  // namespace rectilin
