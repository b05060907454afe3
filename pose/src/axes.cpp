#include "rectilin/pose/axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "surface.h"

namespace rectilin::pose {
namespace {

constexpr double kEqualMoments = 1e-9;

/// The part of a triangle's area, 0 to 1, where a linear function with these values at the corners is positive.
double positive_part(std::array<double, 3> x) {
  std::ranges::sort(x);
  if (x[0] >= 0) return x[2] > 0 ? 1 : 0.5;  // within the plane: half to each side
  if (x[2] <= 0) return 0;
  if (x[1] <= 0) return x[2] / (x[2] - x[1]) * (x[2] / (x[2] - x[0]));
  return 1 - x[0] / (x[0] - x[1]) * (x[0] / (x[0] - x[2]));
}

/// Area on the positive side less that on the negative, over the sum.
double imbalance(const Surface& surface, const Vector3& axis) {
  double positive = 0;
  for (std::size_t i = 0; i < surface.areas.size(); ++i) {
    const Triangle& t = surface.mesh.triangles[i];
    positive +=
        surface.areas[i] * positive_part({axis.dot(surface.mesh.vertices[t[0]]), axis.dot(surface.mesh.vertices[t[1]]),
                                          axis.dot(surface.mesh.vertices[t[2]])});
  }
  return 2 * positive / surface.area - 1;
}

/// Of the frames D R, D among those symmetries, the nearest to the given axes.
template <class Allowed>
Rotation nearest(const Rotation& frame, Allowed allowed) {
  Rotation best = frame;
  double least = 10;
  for (const Rotation& d : frame_symmetries()) {
    if (!allowed(d)) continue;
    const Rotation candidate = d * frame;
    if (const double angle = angle_between(candidate, Rotation()); angle < least) least = angle, best = candidate;
  }
  return best;
}

}  // namespace

Axes resolve_axes(const Mesh& mesh, const Rotation& frame, AxisRule rule) {
  if (rule == AxisRule::kFree) return {reduce_to_zone(frame), true};
  const Surface surface = make_surface(mesh);
  std::array<double, 3> moments;
  for (int k = 0; k < 3; ++k) moments[k] = frame.axis(k).dot(surface.moments * frame.axis(k));
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::stable_sort(order, [&](int a, int b) { return moments[a] > moments[b]; });
  Axes axes;
  for (int k = 0; k < 2; ++k)
    axes.resolved = axes.resolved && moments[order[k]] - moments[order[k + 1]] > kEqualMoments * moments[order[0]];
  Eigen::Matrix3d rows;
  for (int k = 0; k < 3; ++k) rows.row(k) = frame.axis(order[k]).transpose();
  if (rows.determinant() < 0) rows.row(2) = -rows.row(2);
  axes.rotation = Rotation::from_matrix(rows);
  if (rule == AxisRule::kOrdered) {
    axes.rotation = nearest(axes.rotation, [](const Rotation& d) {
      return d.matrix().diagonal().cwiseAbs().minCoeff() > 0.5;  // half turns keep the order
    });
    return axes;
  }
  std::array<double, 3> halves;
  for (int k = 0; k < 3; ++k) halves[k] = imbalance(surface, axes.rotation.axis(k));
  int left = 2;  // the axis that follows from the others: that of the most equal halves, the last if in doubt
  for (int k = 1; k >= 0; --k)
    if (std::abs(halves[k]) < std::abs(halves[left]) - kEqualMoments) left = k;
  for (int k = 0; k < 3; ++k) {
    if (k == left) continue;
    axes.resolved = axes.resolved && std::abs(halves[k]) > kEqualMoments;
    if (halves[k] < -kEqualMoments) rows.row(k) = -rows.row(k);
  }
  if (rows.determinant() < 0) rows.row(left) = -rows.row(left);
  axes.rotation = Rotation::from_matrix(rows);
  return axes;
}

}  // namespace rectilin::pose
