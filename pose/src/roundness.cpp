#include "rectilin/pose/roundness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "frames.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/pose/convex_hull.h"
#include "rectilin/pose/pose.h"
#include "roundness_of.h"

namespace rectilin::pose {
namespace {

struct Range {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  void add(double x) {
    lower = std::min(lower, x);
    upper = std::max(upper, x);
  }
};

}  // namespace

double unroundness(const Surface& surface, const Mesh& hull, const Vector3& axis) {
  const Rotation frame = frame_about(axis);
  const Eigen::Matrix<double, 2, 3> across = frame.matrix().topRows<2>();
  const Eigen::Matrix2d moments = across * surface.moments * across.transpose();
  const double mean = moments.trace() / 2;
  const double half = std::hypot((moments(0, 0) - moments(1, 1)) / 2, moments(0, 1));  // the eigenvalues: mean +- half
  double worst = mean + half > 0 ? 2 * half / (mean + half) : 1;
  constexpr int kDirections = 24;
  Range widths, areas;
  const AreaVectors vectors = area_vectors(hull);
  for (int i = 0; i < kDirections; ++i) {
    const double turn = i * std::numbers::pi / kDirections;
    const Vector3 direction = std::cos(turn) * frame.axis(0) + std::sin(turn) * frame.axis(1);
    Range along;
    for (const Vector3& v : hull.vertices) along.add(v.dot(direction));
    widths.add(along.upper - along.lower);
    double area = 0;
    for (std::size_t k = 0; k < vectors.size(); ++k) area += std::abs(vectors[k].dot(direction));
    areas.add(area);
  }
  for (const Range& range : {widths, areas}) {
    const double sum = range.upper + range.lower;
    worst = std::max(worst, sum > 0 ? (range.upper - range.lower) / sum : 1.0);
  }
  return worst;
}

double unroundness(const Mesh& mesh, const Vector3& axis) {
  const Surface surface = make_surface(mesh);
  return unroundness(surface, convex_hull(surface.mesh), axis);
}

void note_roundness(Pose& pose, const Surface& surface, const Mesh& hull, double tolerance) {
  int free = 0, axis = -1;
  for (int k = 0; k < 3; ++k)
    if (unroundness(surface, hull, pose.rotation.axis(k)) < tolerance) ++free, axis = k;
  if (free == 0) return;
  pose.uniqueness = free == 1 ? Uniqueness::kContinuum : Uniqueness::kNone;
  pose.free_axis = free == 1 ? axis : -1;
  pose.alternatives.clear();
}

}  // namespace rectilin::pose
