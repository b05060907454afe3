#include "features/radial_extent.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rectilin::retrieval {
namespace {

constexpr double kPi = std::numbers::pi;

class SphereGrid {
 public:
  explicit SphereGrid(int n) : n_(n), extent_(static_cast<std::size_t>(n * n)) {
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const double theta = kPi * (j + 0.5) / n, phi = 2 * kPi * k / n;
        directions_.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      }
  }

  /// Only directions inside a cone around the triangle are tried: a cone narrower than a half space is convex, so it
  /// holds the triangle if it holds the corners.
  void draw(const Vector3& a, const Vector3& b, const Vector3& c) {
    const Faces faces{b.cross(c), c.cross(a), a.cross(b), a.dot(b.cross(c))};
    if (a.isZero(0) || b.isZero(0) || c.isZero(0)) return;  // seen edge-on
    const Vector3 u = a.normalized(), v = b.normalized(), w = c.normalized();
    const Vector3 axis = (u + v + w).normalized();
    const double cosine = std::min({axis.dot(u), axis.dot(v), axis.dot(w)});
    if (!(cosine > 0.05)) {
      for (int j = 0; j < n_; ++j) draw_row(faces, j, 0, n_ - 1);
      return;
    }
    const double reach = std::acos(std::min(1.0, cosine)) + 1e-9;
    const double theta = std::acos(std::clamp(axis.z(), -1.0, 1.0)), phi = std::atan2(axis.y(), axis.x());
    const int first = std::max(0, static_cast<int>(std::ceil((theta - reach) / kPi * n_ - 0.5)));
    const int last = std::min(n_ - 1, static_cast<int>(std::floor((theta + reach) / kPi * n_ - 0.5)));
    int left = 0, right = n_ - 1;
    if (theta > reach && theta < kPi - reach) {  // no pole inside
      const double half = std::asin(std::min(1.0, std::sin(reach) / std::sin(theta))) + 1e-9;
      left = static_cast<int>(std::ceil((phi - half) / (2 * kPi) * n_));
      right = std::min(left + n_ - 1, static_cast<int>(std::floor((phi + half) / (2 * kPi) * n_)));
    }
    for (int j = first; j <= last; ++j) draw_row(faces, j, left, right);
  }

  std::vector<double> take() { return std::move(extent_); }

 private:
  struct Faces {
    Vector3 bc, ca, ab;
    double volume;
  };

  void draw_row(const Faces& faces, int j, int left, int right) {
    for (int k = left; k <= right; ++k) {
      const auto at = static_cast<std::size_t>(j * n_ + ((k % n_) + n_) % n_);
      const Vector3& d = directions_[at];
      const double x = d.dot(faces.bc), y = d.dot(faces.ca), z = d.dot(faces.ab);
      const bool inside = (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
      const double sum = x + y + z;
      if (!inside || sum == 0) continue;
      extent_[at] = std::max(extent_[at], faces.volume / sum);  // negative behind the origin
    }
  }

  int n_;
  std::vector<double> extent_;
  std::vector<Vector3> directions_;
};

}  // namespace

std::vector<double> radial_extent(const Mesh& mesh, int n, int pole) {
  SphereGrid grid(n);
  const auto corner = [&](std::uint32_t v) {
    const Vector3& p = mesh.vertices[v];
    return Vector3(p[(pole + 1) % 3], p[(pole + 2) % 3], p[pole]);
  };
  for (const Triangle& t : mesh.triangles) grid.draw(corner(t[0]), corner(t[1]), corner(t[2]));
  return grid.take();
}

std::vector<double> radial_extent(const Mesh& mesh, std::span<const Vector3> directions) {
  std::vector<double> extent(directions.size());
  for (const Triangle& t : mesh.triangles) {
    const Vector3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    if (a.isZero(0) || b.isZero(0) || c.isZero(0)) continue;  // seen edge-on
    const Vector3 bc = b.cross(c), ca = c.cross(a), ab = a.cross(b);
    const double volume = a.dot(bc);
    // Directions outside a cone around the triangle need no closer look; see SphereGrid::draw().
    const Vector3 u = a.normalized(), v = b.normalized(), w = c.normalized();
    const Vector3 axis = (u + v + w).normalized();
    const double cosine = std::min({axis.dot(u), axis.dot(v), axis.dot(w)});
    const double least = cosine > 0.05 ? cosine - 1e-9 : -2;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const Vector3& d = directions[k];
      if (d.dot(axis) < least) continue;
      const double x = d.dot(bc), y = d.dot(ca), z = d.dot(ab), sum = x + y + z;
      const bool inside = (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
      if (inside && sum != 0) extent[k] = std::max(extent[k], volume / sum);  // negative behind the origin
    }
  }
  return extent;
}

}  // namespace rectilin::retrieval
