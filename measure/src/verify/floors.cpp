#include "verify/floors.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

namespace rectilin::verification {
namespace {

constexpr std::size_t kMostTriangles = 6'000'000;
constexpr int kFirst = 2, kDeepest = 26;  // levels of the subdivision: edges of 0.4 radians, of 2e-8
constexpr int kListed = 5;                // triangles keep their lists down to this one
constexpr double kAllowance = 1e-12;      // of a cut's value: a few roundoffs, as sums are in extended precision
constexpr double kAside = 1e-12;          // of a sweep's sides and products of unit vectors: a few roundoffs

}  // namespace

/// Great circles round what axis k sweeps: r_k . normal <= reach, eight of them, all of positive reach.
struct Floors::Sweep {
  std::array<Vector, 8> normals;
  std::array<double, 8> reach;
  Vector middle;
  bool in_front;  // r_k . middle >= 0

  Sweep(const Part& part, int k) {
    const Vector rho = 0.5 * (part.low + part.high);
    middle = row(rho, k);
    const Vector a = row(rho, (k + 1) % 3), b = row(rho, (k + 2) % 3);
    for (int i = 0; i < 8; ++i) {
      const double angle = 0.785398163397448 * i;
      normals[i] = (std::cos(angle) * a + std::sin(angle) * b).normalized();
      reach[i] = std::max(0.0, -least(-normals[i], part, k)) + kAside;
    }
    in_front = least(middle, part, k) > kAside;
  }

  /// Row k of the rotation.
  static Vector row(const Vector& rho, int k) {
    const Vector unit = Vector::Unit(k);
    return ((1 - rho.squaredNorm()) * unit + 2 * rho[k] * rho + 2 * unit.cross(rho)).normalized();
  }

  static double least(const Vector& direction, const Part& part, int k) {
    Eigen::Matrix3d g = Eigen::Matrix3d::Zero();
    g.row(k) = direction.transpose();
    return least_on(g, part);
  }

  /// A unit vector of the triangle is sum a_j p_j with a_j >= 0 that add up to at least 1. So if all p_j are beyond a
  /// side, it is.
  bool misses(const std::array<Vector, 3>& p, double mirror) const {
    for (int i = 0; i < 8; ++i)
      if (mirror * normals[i].dot(p[0]) > reach[i] && mirror * normals[i].dot(p[1]) > reach[i] &&
          mirror * normals[i].dot(p[2]) > reach[i])
        return true;
    return in_front && mirror * middle.dot(p[0]) < -kAside && mirror * middle.dot(p[1]) < -kAside &&
           mirror * middle.dot(p[2]) < -kAside;
  }
};

Floors::Floors(const std::vector<Face>& faces, const Eigen::Matrix3d& form) : faces_(faces), form_(form) {
  lists_.emplace_back().faces.resize(faces.size());
  std::iota(lists_[0].faces.begin(), lists_[0].faces.end(), 0u);
  const Vector x = Vector::UnitX(), y = Vector::UnitY(), z = Vector::UnitZ();
  for (const auto& corners : {std::array<Vector, 3>{x, y, z}, {y, -x, z}, {-x, -y, z}, {-y, x, z}})
    triangles_.emplace_back().corners = corners;
}

Floors::Answer Floors::check(const std::array<double, 3>& floors, const Part& part, int halvings) {
  bool shown = true;
  for (int k = 0; k < 3 && shown; ++k) {
    const Sweep sweep(part, k);
    for (std::int32_t octant = 0; octant < 4 && shown; ++octant)
      for (const double mirror : {1.0, -1.0}) shown = shown && covers(octant, sweep, mirror, floors[k]);
  }
  if (shown) return Answer::kHolds;
  if (too_many_) return Answer::kTooMany;
  if (halvings == 0) return Answer::kFails;
  const int axis = part.longest();
  const Answer lower = check(floors, part.half(axis, false), halvings - 1);
  return lower == Answer::kHolds ? check(floors, part.half(axis, true), halvings - 1) : lower;
}

/// Is h(u) - u . F u at least `floor` on the part of the triangle, mirrored or not, that the axis may sweep?
bool Floors::covers(std::int32_t at, const Sweep& sweep, double mirror, double floor) {
  if (triangles_[at].bound >= floor || sweep.misses(triangles_[at].corners, mirror)) return true;
  if (triangles_[at].level >= kFirst && !show_cut(at, sweep, mirror, floor)) return false;
  if (triangles_[at].bound >= floor) return true;
  if (triangles_[at].level == kDeepest) return false;
  if (triangles_[at].parts < 0) divide(at);
  if (triangles_[at].parts < 0) return false;
  const std::int32_t parts = triangles_[at].parts;
  for (std::int32_t i = 0; i < 4; ++i)
    if (!covers(parts + i, sweep, mirror, floor)) return false;
  double least = triangles_[parts].bound;
  for (std::int32_t i = 1; i < 4; ++i) least = std::min(least, triangles_[parts + i].bound);
  triangles_[at].bound = std::max(triangles_[at].bound, least);
  return true;
}

/// A bound of g . u - u . F u on the triangle. In the plane of the corners u = sum a_j p_j, sum a_j = 1, it is the mean
/// of (g . p_i + g . p_j) / 2 - p_i . F p_j with weights a_i a_j. A point of the sphere is further out by a factor s
/// <= 1.1, which changes it by (s - 1) (g . u - (s + 1) u . F u): not down, if g . p_j >= 2.1 p_i . F p_k for all
/// corners.
double Floors::least(const Vector& g, const std::array<Vector, 3>& p) const {
  double least = std::numeric_limits<double>::infinity(), linear = least, most = 0;
  for (int i = 0; i < 3; ++i) {
    linear = std::min(linear, g.dot(p[i]));
    for (int j = 0; j < 3; ++j) {
      const double product = p[i].dot(form_ * p[j]);
      most = std::max(most, product);
      least = std::min(least, 0.5 * (g.dot(p[i]) + g.dot(p[j])) - product);
    }
  }
  return linear >= 2.1 * most + kAside ? least : -std::numeric_limits<double>::infinity();
}

/// Raises the triangle's bound to that of the cut at its centre c, if that was not done: h(u) >= g . u for every u.
/// False if the floor does not hold at c, where the axis may well point to.
bool Floors::show_cut(std::int32_t at, const Sweep& sweep, double mirror, double floor) {
  if (triangles_[at].cut) return true;
  const std::array<Vector, 3> p = triangles_[at].corners;
  const List& above = list_over(at);
  const List own = narrowed(above, p);
  const Vector c = (p[0] + p[1] + p[2]).normalized();
  Extended sum = own.settled;
  for (const std::uint32_t i : own.faces) {
    const Face& v = faces_[i];
    const double side = c.x() * v.x + c.y() * v.y + c.z() * v.z < 0 ? -1 : 1;
    sum += side * Extended(v.x, v.y, v.z);
  }
  const Vector g = sum.cast<double>();
  Triangle& triangle = triangles_[at];
  triangle.bound = std::max(triangle.bound, least(g, p) - kAllowance);
  triangle.cut = true;
  return g.dot(c) - c.dot(form_ * c) >= floor || sweep.misses({c, c, c}, mirror);
}

/// The list of the triangle or of the smallest one above it that keeps one.
const Floors::List& Floors::list_over(std::int32_t at) {
  if (at < 0) return lists_[0];
  if (triangles_[at].list < 0) {
    const List& above = list_over(triangles_[at].above);
    if (triangles_[at].level > kListed) return above;
    List own = narrowed(above, triangles_[at].corners);
    triangles_[at].list = static_cast<std::int32_t>(lists_.size());
    lists_.push_back(std::move(own));
  }
  return lists_[triangles_[at].list];
}

/// Where rounding takes a face for settled that is not, its sign is that of a valid cut all the same.
Floors::List Floors::narrowed(const List& list, const std::array<Vector, 3>& p) const {
  List result;
  result.settled = list.settled;
  for (const std::uint32_t i : list.faces) {
    const Face& v = faces_[i];
    int positive = 0;
    for (const Vector& corner : p) positive += corner.x() * v.x + corner.y() * v.y + corner.z() * v.z > 0;
    if (positive == 3) result.settled += Extended(v.x, v.y, v.z);
    else if (positive == 0) result.settled -= Extended(v.x, v.y, v.z);
    else result.faces.push_back(i);
  }
  return result;
}

/// Into four round the midpoints of the edges, which are the same from either side.
void Floors::divide(std::int32_t at) {
  if (triangles_.size() + 4 > kMostTriangles) {
    too_many_ = true;
    return;
  }
  const Triangle whole = triangles_[at];
  const auto& p = whole.corners;
  const Vector a = (p[1] + p[2]).normalized(), b = (p[2] + p[0]).normalized(), c = (p[0] + p[1]).normalized();
  triangles_[at].parts = static_cast<std::int32_t>(triangles_.size());
  for (const auto& corners : {std::array<Vector, 3>{a, b, c}, {p[0], c, b}, {c, p[1], a}, {b, a, p[2]}}) {
    Triangle& part = triangles_.emplace_back();
    part.corners = corners;
    part.bound = whole.bound;
    part.above = at;
    part.level = static_cast<std::int8_t>(whole.level + 1);
  }
}

}  // namespace rectilin::verification
