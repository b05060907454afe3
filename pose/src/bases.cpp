#include "bases.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rectilin::pose {
namespace {

constexpr double kFacingWidth = 0.14, kFlatWidth = 0.052;  // radians: standard deviations
constexpr double kWidths = 4;                              // of these, beyond which nothing counts
constexpr std::size_t kSeeds = 256;                        // faces that a flat side may be found from
constexpr double kDistinctSides = 10 * std::numbers::pi / 180;

/// exp(-a^2 / (2 width^2)) for the angle a of this cosine, where a is small.
double bell(double cosine, double width) { return std::exp((cosine - 1) / (width * width)); }

}  // namespace

Bases::Bases(const Mesh& hull) {
  for (const Triangle& t : hull.triangles) {
    const Vector3& a = hull.vertices[t[0]];
    const Vector3 cross = (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a);
    if (cross.norm() > 0) faces_.push_back({cross.normalized(), cross.norm() / 2});
  }
  std::ranges::stable_sort(faces_, std::greater(), &Face::area);
}

double Bases::share(const Vector3& axis) const {
  const double cut = std::cos(kWidths * kFacingWidth);
  double front = 0, back = 0, outline = 0;
  for (const Face& face : faces_) {
    const double cosine = face.normal.dot(axis);
    outline += face.area * std::abs(cosine) / 2;
    if (cosine > cut) front += face.area * bell(cosine, kFacingWidth);
    else if (cosine < -cut) back += face.area * bell(-cosine, kFacingWidth);
  }
  return outline > 0 ? std::max(front, back) / outline : 0;
}

std::vector<Vector3> Bases::flattest(std::size_t count) const {
  struct Side {
    double area = 0;
    Vector3 direction = Vector3::Zero();
  };
  const double cut = std::cos(kWidths * kFlatWidth);
  std::vector<Side> sides;
  for (std::size_t i = 0; i < std::min(faces_.size(), kSeeds); ++i) {
    Side side;
    for (const Face& face : faces_) {
      const double cosine = face.normal.dot(faces_[i].normal);
      if (cosine < cut) continue;
      const double area = face.area * bell(cosine, kFlatWidth);
      side.area += area;
      side.direction += area * face.normal;
    }
    side.direction.normalize();
    sides.push_back(side);
  }
  std::ranges::stable_sort(sides, std::greater(), &Side::area);
  std::vector<Vector3> kept;
  for (const Side& side : sides) {
    if (kept.size() == count) break;
    const auto near = [&](const Vector3& d) { return std::abs(d.dot(side.direction)) > std::cos(kDistinctSides); };
    if (std::ranges::none_of(kept, near)) kept.push_back(side.direction);
  }
  return kept;
}

}  // namespace rectilin::pose
