#include "silhouette/contours.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "rectilin/render/camera.h"
#include "views/placed.h"

namespace rectilin::render {
namespace {

/// Numbers distinct keys in the order in which they come: a hash table with open addressing.
template <class Key, class Hash>
class Numbering {
 public:
  Numbering(std::size_t most, Hash hash) : hash_(hash), slots_(std::bit_ceil(2 * most + 2), kFree) {}

  std::uint32_t operator()(const Key& key, std::vector<Key>& keys) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash_(key) & mask;; i = (i + 1) & mask) {
      if (slots_[i] == kFree) {
        slots_[i] = static_cast<std::uint32_t>(keys.size());
        keys.push_back(key);
        return slots_[i];
      }
      if (keys[slots_[i]] == key) return slots_[i];
    }
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};
  Hash hash_;
  std::vector<std::uint32_t> slots_;
};

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 32)) * 0x9e3779b97f4a7c15u;
  return bits ^ (bits >> 29);
}

std::uint64_t hash_of(const Vector3& p) {
  std::uint64_t h = 0;
  for (const double x : {p.x(), p.y(), p.z()}) h = mixed(h + std::bit_cast<std::uint64_t>(x + 0.0));  // -0 is 0
  return h;
}

}  // namespace

Silhouette::Contours::Contours(const Mesh& mesh) : exponent_(size_exponent(mesh)) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  std::vector<Vector3> places;
  Numbering<Vector3, std::uint64_t (*)(const Vector3&)> number_place(mesh.vertices.size(), hash_of);
  std::vector<std::uint32_t> place_of(mesh.vertices.size(), kNone);
  using Edge = std::array<std::uint32_t, 2>;
  const auto hash_edge = [](const Edge& e) { return mixed(std::uint64_t{e[0]} << 32 | e[1]); };
  Numbering<Edge, decltype(hash_edge)> number_edge(3 * mesh.triangles.size(), hash_edge);
  for (const Triangle& t : mesh.triangles) {
    Face face{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& place = place_of[t[i]];
      if (place == kNone) place = number_place(times_power(mesh.vertices[t[i]], -exponent_), places);
      face.corners[i] = place;
    }
    const auto& [a, b, c] = face.corners;
    if (a == b || b == c || c == a) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = face.corners[i], to = face.corners[(i + 1) % 3];
      face.edges[i] = number_edge(from < to ? Edge{from, to} : Edge{to, from}, edges_);
      face.along[i] = from < to ? 1 : -1;
      perimeters_ += (places[to] - places[from]).norm();
    }
    faces_.push_back(face);
  }

  Vector3 lower = Vector3::Constant(2), upper = -lower;
  for (const Vector3& p : places) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  const Vector3 centre = places.empty() ? Vector3(Vector3::Zero()) : Vector3((lower + upper) / 2);
  for (Vector3& p : places) {
    p -= centre;
    radius_ = std::max(radius_, p.norm());
  }
  points_ = std::move(places);
}

Silhouette::Contours::Picture Silhouette::Contours::seen_along(const Vector3& direction) const {
  const Rotation frame = frame_towards(direction);
  const Vector3 right = frame.axis(0), up = frame.axis(1);
  std::vector<Eigen::Vector2d> points;
  points.reserve(points_.size());
  for (const Vector3& p : points_) points.emplace_back(right.dot(p), up.dot(p));

  Picture picture;
  // Axes (by at most 14 units of 2^-53 times the radius) and sums (by 5) are rounded: each corner is moved by at most
  // `moved`, in both coordinates together. A triangle whose corners are moved so far
  // differs from the old one in a band along its perimeter.
  const double moved = 0x1p-48 * radius_;
  picture.slack = (1 + 0x1p-40) *
                  (2 * perimeters_ * moved + 4 * std::numbers::pi * static_cast<double>(faces_.size()) * moved * moved);

  std::vector<std::int32_t> winding(edges_.size(), 0);
  for (const Face& face : faces_) {
    const Eigen::Vector2d &a = points[face.corners[0]], &b = points[face.corners[1]], &c = points[face.corners[2]];
    const double first = (b.x() - a.x()) * (c.y() - a.y()), second = (b.y() - a.y()) * (c.x() - a.x());
    const double area = first - second, doubt = 0x1p-50 * (std::abs(first) + std::abs(second));
    if (std::abs(area) <= doubt) {  // which way it is turned is not sure: it is left out
      picture.slack += doubt;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) winding[face.edges[i]] += area > 0 ? face.along[i] : -face.along[i];
  }
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (winding[i] == 0) continue;
    // A triangle lies on the left of its sides: going up it ends there, for who comes from the left.
    const Eigen::Vector2d &a = points[edges_[i][0]], &b = points[edges_[i][1]];
    if (a.y() < b.y()) picture.edges.push_back({a.x(), a.y(), b.x(), b.y(), -winding[i]});
    if (a.y() > b.y()) picture.edges.push_back({b.x(), b.y(), a.x(), a.y(), winding[i]});
  }
  return picture;
}

}  // namespace rectilin::render
