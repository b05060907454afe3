#include "rectilin/pose/convex_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numeric>

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

#include "rectilin/base/symmetric.h"

namespace rectilin::pose {
namespace {

constexpr double kFlat = 1e-9;

/// The mesh's corners, in a unit in which none is larger than one.
std::vector<Vector3> corners(const Mesh& mesh, double& unit) {
  std::vector<char> used(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
    for (const auto corner : t) used[corner] = 1;
  double largest = 0;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) largest = std::max(largest, mesh.vertices[i].cwiseAbs().maxCoeff());
  int exponent = 0;
  std::frexp(largest, &exponent);
  unit = std::ldexp(1.0, std::min(exponent, 1023));
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) points.push_back(mesh.vertices[i] / unit);
  return points;
}

struct Spread {
  Eigen::Matrix3d axes;  ///< columns, by increasing extent
  Vector3 extents, middle;
};

Spread spread(const std::vector<Vector3>& points) {
  Vector3 mean = Vector3::Zero();
  for (const Vector3& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Vector3& p : points) moments += (p - mean) * (p - mean).transpose();
  Spread result{symmetric_eigen(moments).vectors, Vector3::Zero(), mean};
  for (int k = 0; k < 3; ++k) {
    double lower = 0, upper = 0;
    for (const Vector3& p : points) {
      const double x = (p - mean).dot(result.axes.col(k));
      lower = std::min(lower, x);
      upper = std::max(upper, x);
    }
    result.extents[k] = upper - lower;
  }
  return result;
}

/// Andrew's monotone chain (1979) in the plane of the two longest axes; the outline as a fan from both sides.
Mesh flat_hull(const std::vector<Vector3>& points, const Spread& spread) {
  struct Flat {
    double x, y;
    std::size_t index;
  };
  std::vector<Flat> flat;
  for (std::size_t i = 0; i < points.size(); ++i)
    flat.push_back(
        {(points[i] - spread.middle).dot(spread.axes.col(2)), (points[i] - spread.middle).dot(spread.axes.col(1)), i});
  std::ranges::sort(flat, [](const Flat& a, const Flat& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto turns_right = [](const Flat& a, const Flat& b, const Flat& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= 0;
  };
  std::vector<Flat> chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = chain.size();
    for (const Flat& p : flat) {
      while (chain.size() >= first + 2 && turns_right(chain[chain.size() - 2], chain.back(), p)) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::ranges::reverse(flat);
  }
  Mesh hull;
  for (const Flat& p : chain) hull.vertices.push_back(points[p.index]);
  const auto n = static_cast<std::uint32_t>(chain.size());
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    hull.triangles.push_back({0, i, i + 1});
    hull.triangles.push_back({0, i + 1, i});
  }
  if (hull.triangles.empty()) throw MeshError("its vertices are all on one line");
  return hull;
}

/// Closes Qhull's memory and its message file whatever happens.
struct Qhull {
  qhT state{};
  std::unique_ptr<FILE, int (*)(FILE*)> messages{std::tmpfile(), std::fclose};

  Qhull() { qh_zero(&state, messages.get()); }
  ~Qhull() {
    qh_freeqhull(&state, !qh_ALL);
    int long_bytes = 0, pieces = 0;
    qh_memfreeshort(&state, &long_bytes, &pieces);
  }
};

Mesh solid_hull(const std::vector<Vector3>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vector3& p : points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
  Qhull library;
  qhT* qh = &library.state;
  char command[] = "qhull Qt Pp";
  if (qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(), False, command, nullptr,
                   library.messages.get()) != qh_ERRnone)
    throw MeshError("its convex hull cannot be found");

  Mesh hull;
  std::vector<std::uint32_t> place(points.size(), std::numeric_limits<std::uint32_t>::max());
  facetT* facet = nullptr;
  vertexT *vertex = nullptr, **vertexp = nullptr;
  FORALLfacets {
    Triangle triangle{};
    int corner = 0;
    FOREACHvertex_(facet->vertices) {
      const auto i = static_cast<std::size_t>(qh_pointid(qh, vertex->point));
      if (place[i] == std::numeric_limits<std::uint32_t>::max()) {
        place[i] = static_cast<std::uint32_t>(hull.vertices.size());
        hull.vertices.push_back(points[i]);
      }
      if (corner < 3) triangle[static_cast<std::size_t>(corner++)] = place[i];
    }
    const Vector3 &a = hull.vertices[triangle[0]], &b = hull.vertices[triangle[1]], &c = hull.vertices[triangle[2]];
    const Eigen::Map<const Vector3> outward(facet->normal);
    if ((b - a).cross(c - a).dot(outward) < 0) std::swap(triangle[1], triangle[2]);
    hull.triangles.push_back(triangle);
  }
  return hull;
}

}  // namespace

Mesh convex_hull(const Mesh& mesh) {
  double unit = 1;
  const std::vector<Vector3> points = corners(mesh, unit);
  if (points.size() < 3) throw MeshError("its vertices are all on one line");
  const Spread shape = spread(points);
  const double size = shape.extents.maxCoeff();
  if (!(shape.extents[1] > kFlat * size)) throw MeshError("its vertices are all on one line");
  Mesh hull = shape.extents[0] > kFlat * size ? solid_hull(points) : flat_hull(points, shape);
  for (Vector3& v : hull.vertices) v *= unit;
  return hull;
}

}  // namespace rectilin::pose
