#include "certify/sphere_minorants.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

namespace rectilin::bounding {
namespace {

constexpr int kMaxDepth = 14;          // of the search inside a patch of the finest level
constexpr int kTaskLevel = 3;          // patches of this level are built in tasks of their own
constexpr double kRounding = 0x1p-44;  // of everything but the sums over faces, relative to |l| + S

Eigen::Vector3d centre_of(const Triangle3& p) { return (p[0] + p[1] + p[2]).normalized(); }

double plane_distance(const Triangle3& p) {
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
  return std::abs(normal.dot(p[0])) / normal.norm() * (1 - 1e-9);
}

/// The minimum over the triangle of a . u, from below: u = sum a_i p_i with a_i >= 0 and 1 <= sum a_i <= 1 / distance.
double least_linear(const Eigen::Vector3d& a, const Triangle3& p, double distance) {
  const double least = std::min({a.dot(p[0]), a.dot(p[1]), a.dot(p[2])});
  return least >= 0 ? least : least / distance;
}

/// Four triangles round the midpoints of the edges. A midpoint has the same bits seen from either side.
std::array<Triangle3, 4> quarters(const Triangle3& p) {
  const Eigen::Vector3d a = (p[1] + p[2]).normalized(), b = (p[2] + p[0]).normalized(), c = (p[0] + p[1]).normalized();
  return {Triangle3{a, b, c}, Triangle3{p[0], c, b}, Triangle3{c, p[1], a}, Triangle3{b, a, p[2]}};
}

/// The search for the minimum of h - l . u over a triangle: a branch and bound of its own, depth first.
class PatchSearch {
 public:
  PatchSearch(double tolerance, std::uint64_t& pairs) : tolerance_(tolerance), pairs_(pairs), pool_(kMaxDepth + 1) {}

  /// `settled` is the gradient of the faces not in the list; `upper` a value of h - l . u in the triangle.
  double minimum(const GeneratorList& faces, const Eigen::Vector3d& settled, const Triangle3& p,
                 const Eigen::Vector3d& slope, double upper) {
    upper_ = upper;
    slope_ = slope;
    return search(faces, settled, p, 0);
  }

 private:
  double search(const GeneratorList& faces, const Eigen::Vector3d& settled, const Triangle3& p, int depth) {
    const Eigen::Vector3d centre = centre_of(p);
    const Eigen::Vector3d gradient = settled + faces.cut(centre) - slope_;
    pairs_ += faces.size();
    upper_ = std::min(upper_, gradient.dot(centre));
    double bound = least_linear(gradient, p, plane_distance(p));
    if (faces.size() == 0 || bound >= upper_ - tolerance_ || depth == kMaxDepth) return bound;
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle3& quarter : quarters(p)) {
      const Eigen::Vector3d more = faces.split(quarter, pool_[depth]);
      pairs_ += faces.size();
      least = std::min(least, search(pool_[depth], settled + more, quarter, depth + 1));
    }
    return std::max(bound, least);
  }

  double tolerance_, upper_ = 0;
  std::uint64_t& pairs_;
  Eigen::Vector3d slope_;
  std::vector<GeneratorList> pool_;
};

}  // namespace

class SphereMinorants::Builder {
 public:
  Builder(SphereMinorants& result, double tolerance, const std::function<bool()>& stop)
      : result_(result), tolerance_(tolerance), stop_(stop) {}

  std::uint64_t build(const GeneratorList& faces, const Eigen::Vector3d& settled, const Triangle3& p, int level,
                      std::size_t index) {
    if (stop_()) throw Stopped();
    Patch& patch = result_.levels_[level][index];
    patch.corners = p;
    patch.centre = centre_of(p);
    patch.distance = plane_distance(p);
    patch.cosine = std::min({patch.centre.dot(p[0]), patch.centre.dot(p[1]), patch.centre.dot(p[2])});
    const Eigen::Vector3d h = values_at_corners(faces, settled, p);
    patch.minorant.slope = tangential_slope(patch, h);
    std::uint64_t pairs = 3 * faces.size();
    if (level + 1 == std::ssize(result_.levels_)) {
      PatchSearch search(tolerance_, pairs);
      const Eigen::Vector3d& l = patch.minorant.slope;
      const double upper = std::min({h[0] - l.dot(p[0]), h[1] - l.dot(p[1]), h[2] - l.dot(p[2])});
      patch.minorant.offset = search.minimum(faces, settled, p, l, upper);
      return pairs;
    }
    return pairs + build_parts(faces, settled, patch, level, index);
  }

 private:
  std::uint64_t build_parts(const GeneratorList& faces, const Eigen::Vector3d& settled, Patch& patch, int level,
                            std::size_t index) {
    const std::array<Triangle3, 4> parts = quarters(patch.corners);
    std::array<std::uint64_t, 4> pairs = {};
    const auto build_part = [&](std::size_t i) {
      GeneratorList active;
      const Eigen::Vector3d more = faces.split(parts[i], active);
      pairs[i] = faces.size() + build(active, settled + more, parts[i], level + 1, 4 * index + i);
    };
    if (level < kTaskLevel) tbb::parallel_for(std::size_t{0}, std::size_t{4}, build_part);
    else
      for (std::size_t i = 0; i < 4; ++i) build_part(i);

    patch.minorant.offset = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 4; ++i) {
      const Patch& part = result_.levels_[level + 1][4 * index + i];
      const double change = least_linear(part.minorant.slope - patch.minorant.slope, part.corners, part.distance);
      patch.minorant.offset = std::min(patch.minorant.offset, part.minorant.offset + change);
    }
    return pairs[0] + pairs[1] + pairs[2] + pairs[3];
  }

  static Eigen::Vector3d values_at_corners(const GeneratorList& faces, const Eigen::Vector3d& settled,
                                           const Triangle3& p) {
    Eigen::Vector3d h;
    for (int i = 0; i < 3; ++i) h[i] = (settled + faces.cut(p[i])).dot(p[i]);
    return h;
  }

  /// The slope at the scale of the patch: h - l . u is the same at its three corners, and l is tangential at its
  /// centre. A subgradient's slope would follow every facet of a fine mesh and be useless a facet further.
  static Eigen::Vector3d tangential_slope(const Patch& patch, const Eigen::Vector3d& h) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.row(i) = patch.corners[i].transpose();
    const Eigen::Matrix3d inverse = corners.inverse();
    const Eigen::Vector3d through = inverse * h, constant = inverse * Eigen::Vector3d::Ones();
    return through - constant * (through.dot(patch.centre) / constant.dot(patch.centre));
  }

  SphereMinorants& result_;
  double tolerance_;
  const std::function<bool()>& stop_;
};

SphereMinorants::SphereMinorants(const Generators& generators, int levels, double tolerance,
                                 const std::function<bool()>& stop) {
  for (int i = 0; i < levels; ++i) levels_.emplace_back(std::size_t{4} << (2 * i));
  const GeneratorList all(generators);
  double total = 0;
  for (std::size_t i = 0; i < generators.size(); ++i) total += generators[i].norm();
  // A sum of K terms, in whatever order, errs by at most K roundoffs of the sum of the lengths.
  rounding_ = total * (static_cast<double>(generators.size()) * 0x1p-52 + kRounding);

  Builder builder(*this, tolerance, stop);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  const std::array<Triangle3, 4> upper = {Triangle3{x, y, z}, {y, -x, z}, {-x, -y, z}, {-y, x, z}};
  std::array<std::uint64_t, 4> pairs;
  tbb::parallel_for(std::size_t{0}, std::size_t{4}, [&](std::size_t i) {
    GeneratorList active;
    const Eigen::Vector3d settled = all.split(upper[i], active);
    pairs[i] = all.size() + builder.build(active, settled, upper[i], 0, i);
  });
  for (const std::uint64_t p : pairs) pairs_ += p;
}

std::optional<Minorant> SphereMinorants::on_cap(const Eigen::Vector3d& u, double angle) const {
  // Triangles about as large as the cap: a few meet it.
  int level = 0;
  for (double size = std::numbers::pi / 2; level + 1 < std::ssize(levels_) && size > 1.5 * angle; size /= 2) ++level;

  struct Hit {
    const Patch* patch;
    double side;  // h is even: -1 stands for the mirrored patch of the lower hemisphere
  };
  struct Item {
    int level;
    std::size_t index;
    double side;
  };
  constexpr int kMostHits = 256;
  std::array<Hit, kMostHits> hits;
  std::array<Item, 64> stack;
  int hit_count = 0, depth = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (const double side : {1.0, -1.0}) stack[depth++] = {0, i, side};
  const double cosine = std::cos(angle), sine = std::sin(angle);
  while (depth > 0) {
    const Item item = stack[--depth];
    const Patch& patch = levels_[item.level][item.index];
    const double reach = cosine * patch.cosine - sine * std::sqrt(1 - patch.cosine * patch.cosine);
    if (item.side * patch.centre.dot(u) < reach - 1e-12) continue;
    if (item.level == level) {
      if (hit_count == kMostHits) return std::nullopt;
      hits[hit_count++] = {&patch, item.side};
    } else {
      for (std::size_t i = 0; i < 4; ++i) stack[depth++] = {item.level + 1, 4 * item.index + i, item.side};
    }
  }

  // The slope of the patch nearest to u, made tangential at u: the radial part belongs into the offset.
  Minorant result;
  double nearest = -2;
  for (int i = 0; i < hit_count; ++i) {
    const double product = hits[i].side * hits[i].patch->centre.dot(u);
    if (product > nearest) nearest = product, result.slope = hits[i].side * hits[i].patch->minorant.slope;
  }
  result.slope -= result.slope.dot(u) * u;
  result.offset = std::numeric_limits<double>::infinity();
  double steepest = 0;
  for (int i = 0; i < hit_count; ++i) {
    const Patch& patch = *hits[i].patch;
    const double change =
        least_linear(patch.minorant.slope - hits[i].side * result.slope, patch.corners, patch.distance);
    result.offset = std::min(result.offset, patch.minorant.offset + change);
    steepest = std::max(steepest, patch.minorant.slope.norm());
  }
  if (hit_count == 0) return std::nullopt;
  result.offset -= rounding_ + kRounding * steepest;
  return result;
}

}  // namespace rectilin::bounding
