#include "rectilin/render/view_sphere.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include "rectilin/base/rotation.h"

namespace rectilin::render {
namespace {

using Pair = std::array<std::uint32_t, 2>;

/// Adds the squares from the smallest up, whatever the axes they belong to: directions that differ by the order and
/// signs of their coordinates stay so exactly.
Vector3 normalized(const Vector3& v) {
  std::array<double, 3> squares = {v.x() * v.x(), v.y() * v.y(), v.z() * v.z()};
  std::sort(squares.begin(), squares.end());
  return v / std::sqrt(squares[0] + squares[1] + squares[2]);
}

Pair sorted(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

ViewSphere::ViewSphere(int level) : level_(level) {
  if (level < 0 || level > kHighest)
    throw std::invalid_argument("a sphere of views has a level from 0 to " + std::to_string(kHighest));
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) directions_.push_back(sign * Vector3::Unit(axis));
  for (const std::uint32_t x : {0u, 1u})
    for (const std::uint32_t y : {2u, 3u})
      for (const std::uint32_t z : {4u, 5u}) {
        const bool even = (x + y + z) % 2 == 0;  // an even number of negative axes keeps the orientation
        faces_.push_back(even ? Triangle{x, y, z} : Triangle{x, z, y});
      }

  std::map<Pair, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [place, is_new] = middles.try_emplace(sorted(a, b), static_cast<std::uint32_t>(directions_.size()));
    if (is_new) {
      edges_.push_back(place->first);
      directions_.push_back(normalized(directions_[a] + directions_[b]));
    }
    return place->second;
  };
  for (int i = 0; i < level; ++i) {
    std::vector<Triangle> split;
    for (const auto& [a, b, c] : faces_) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
        split.push_back(t);
    }
    faces_ = std::move(split);
  }

  // A symmetry is known by what it does to the axes: it takes middles of edges to middles of edges.
  const auto extended = [&](const std::function<Vector3(const Vector3&)>& symmetry) {
    std::vector<std::uint32_t> image;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto closest = std::max_element(
          directions_.begin(), directions_.begin() + 6,
          [goal = symmetry(directions_[k])](const Vector3& u, const Vector3& v) { return u.dot(goal) < v.dot(goal); });
      image.push_back(static_cast<std::uint32_t>(closest - directions_.begin()));
    }
    for (const auto& [a, b] : edges_) image.push_back(middles.at(sorted(image[a], image[b])));
    return image;
  };
  opposite_ = extended([](const Vector3& d) { return Vector3(-d); });
  for (const Rotation& d : frame_symmetries())
    permutations_.push_back(extended([&](const Vector3& u) { return Vector3(d.matrix().transpose() * u); }));
}

ViewSphere ViewSphere::of_size(std::size_t directions) {
  std::string sizes;
  for (int level = 0; level <= kHighest; ++level) {
    const std::size_t size = (std::size_t{4} << (2 * level)) + 2;
    if (size == directions) return ViewSphere(level);
    sizes += (level == 0 ? "" : level == kHighest ? " or " : ", ") + std::to_string(size);
  }
  throw std::invalid_argument("a sphere of views has " + sizes + " directions, not " + std::to_string(directions));
}

}  // namespace rectilin::render
