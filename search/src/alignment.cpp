#include "alignment.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "rectilin/base/rotation.h"
#include "rectilin/base/symmetric.h"

namespace rectilin::search {
namespace {

constexpr std::size_t kFitSamples = 2000;   // of a surface
constexpr std::size_t kFitVertices = 2000;  // of a mesh with more so many are looked at
constexpr std::size_t kCoarse = 20;         // every so many samples decide which turns are worth refining
constexpr std::size_t kFine = 8;            // every so many are used to refine
constexpr std::size_t kFineVertices = 400;  // and so many vertices of a mesh with more
constexpr std::size_t kRefined = 4;         // turns that are
constexpr int kRounds = 20;
constexpr double kOutOfReach = 0.3;    // what a sample without a foot counts for
constexpr double kSameVertex = 0.001;  // vertices that are nearer are one
constexpr double kStill = 1e-7;        // steps of a refinement that move nothing any more

}  // namespace

AlignedShape::AlignedShape(const retrieval::Model& model) {
  // Within the unit ball about the centre of mass first, so that coordinates of any size can be multiplied.
  const retrieval::Frame frame = retrieval::surface_frame(model.mesh());
  const Mesh mesh = retrieval::transformed(model.mesh(), frame);
  std::vector<double> ends;
  double area = 0;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Triangle& t : mesh.triangles) {
    const Vector3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const double own = (b - a).cross(c - a).norm() / 2;
    area += own;
    ends.push_back(area);
    const Vector3 g = a + b + c;
    second += own / 12 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + g * g.transpose());
  }
  if (!(area > 0)) throw MeshError("no area");
  second /= area;
  const double rms = std::sqrt(second.trace());
  const SymmetricEigen eigen = symmetric_eigen(second);
  for (int k = 0; k < 3; ++k) {
    principal_.row(k) = eigen.vectors.col(2 - k).transpose();
    moments_(k) = eigen.values(2 - k) / second.trace();
  }
  if (principal_.determinant() < 0) principal_.row(2) *= -1;
  rectilinear_ = model.frame("rectilinear").rotation.matrix();
  unit_ = rms / frame.scale;
  centre_ = frame.centre;

  std::vector<SurfaceTree::Corners> triangles;
  for (const Triangle& t : mesh.triangles)
    triangles.push_back({principal_ * mesh.vertices[t[0]] / rms, principal_ * mesh.vertices[t[1]] / rms,
                         principal_ * mesh.vertices[t[2]] / rms});
  std::size_t triangle = 0;
  for (std::size_t k = 0; k < kFitSamples; ++k) {
    const double at = area * (static_cast<double>(k) + 0.5) / kFitSamples;
    while (triangle + 1 < ends.size() && ends[triangle] < at) ++triangle;
    // Roberts's sequence fills the triangle evenly.
    double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(k), 1.0);
    double v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(k), 1.0);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto& t = triangles[triangle];
    samples_.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
  }

  for (const auto& t : triangles)
    for (const Vector3& corner : t) vertices_.push_back(corner);
  const auto before = [](const Vector3& u, const Vector3& v) {
    return std::lexicographical_compare(u.data(), u.data() + 3, v.data(), v.data() + 3);
  };
  std::ranges::sort(vertices_, before);
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
  tree_ = SurfaceTree(triangles);
  std::vector<SurfaceTree::Corners> points;
  for (const Vector3& v : vertices_) points.push_back({v, v, v});
  vertex_tree_ = SurfaceTree(points);
}

namespace {

/// The mean of the squares of distances of samples from a surface.
double one_sided(const AlignedShape& surface, const AlignedShape& samples, const Eigen::Matrix3d& linear,
                 const Vector3& shift, std::size_t every) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.samples().size(); i += every) {
    const Vector3 p = linear * samples.samples()[i] + shift;
    const double d = std::min(kOutOfReach, surface.tree().nearest(p, kOutOfReach).distance);
    sum += d * d;
    ++count;
  }
  return sum / static_cast<double>(count);
}

/// Steps of the iterative closest point method with distances from planes (Chen and Medioni 1992), turn, shift and
/// scale together. Points of the second shape are weighed by how far they are from the first.
class Step {
 public:
  void add(const SurfaceTree& surface, const Vector3& p, const SurfaceTree::Foot& foot, double weight) {
    // At edges the way to the foot is no normal of the triangle; it is what is left to go all the same.
    const Vector3 n = foot.distance > 1e-9 ? Vector3((p - foot.point) / foot.distance) : surface.normal(foot.triangle);
    Eigen::Matrix<double, 7, 1> row;
    row << p.cross(n), n, p.dot(n);
    normal_ += weight * row * row.transpose();
    right_ -= weight * row * foot.distance;
  }

  /// Returns how much it moved the fit; 0 if it cannot be moved.
  double apply(Fit& fit) {
    normal_.diagonal().array() += 1e-6 * normal_.trace() + 1e-300;
    const Eigen::Matrix<double, 7, 1> step = solve_symmetric(normal_, right_);
    if (!step.allFinite()) return 0;
    const double size = 1 + std::clamp(step(6), -0.1, 0.1);
    const Eigen::Matrix3d turn = rotation_from_vector(step.head<3>()).matrix() * size;
    fit.linear = turn * fit.linear;
    fit.shift = turn * fit.shift + step.segment<3>(3);
    return step.norm();
  }

 private:
  Eigen::Matrix<double, 7, 7> normal_ = Eigen::Matrix<double, 7, 7>::Zero();
  Eigen::Matrix<double, 7, 1> right_ = Eigen::Matrix<double, 7, 1>::Zero();
};

void refine(const AlignedShape& first, const AlignedShape& second, Fit& fit) {
  std::vector<std::uint32_t> last(second.samples().size(), SurfaceTree::kNoGuess);  // triangles that were nearest
  for (int round = 0; round < kRounds; ++round) {
    Step step;
    for (std::size_t i = 0; i < second.samples().size(); i += kFine) {
      const Vector3 p = fit.linear * second.samples()[i] + fit.shift;
      const SurfaceTree::Foot foot = first.tree().nearest(p, kOutOfReach / 2, last[i]);
      last[i] = foot.triangle;
      if (std::isfinite(foot.distance)) step.add(first.tree(), p, foot, 1);
    }
    if (step.apply(fit) < kStill) return;
  }
}

/// Sets the distance between the surfaces; false if one of them has shrunk to nothing.
bool measure(const AlignedShape& first, const AlignedShape& second, Fit& fit, std::size_t every) {
  if (!(std::abs(fit.linear.determinant()) > 0.01)) return false;
  const Fit back = inverse(fit);
  const double scale = std::cbrt(std::abs(fit.linear.determinant()));
  const double there = one_sided(first, second, fit.linear, fit.shift, every);
  const double home = one_sided(second, first, back.linear, back.shift, every) * scale * scale;
  fit.distance = std::sqrt((there + home) / 2);
  return true;
}

}  // namespace

Fit inverse(const Fit& fit) {
  Fit back = fit;
  back.linear = fit.linear.inverse();
  back.shift = -back.linear * fit.shift;
  return back;
}

Fit best_fit(const AlignedShape& first, const AlignedShape& second, bool mirrored) {
  std::vector<Fit> starts;
  const auto add = [&](const Eigen::Matrix3d& linear) {
    Fit fit;
    fit.linear = linear;
    fit.distance = one_sided(first, second, linear, fit.shift, kCoarse);
    starts.push_back(fit);
  };
  for (const Rotation& d : frame_symmetries()) {
    // In the principal axes of both; equal moments may have put the axes in another order.
    const Eigen::Matrix3d flip = mirrored ? Eigen::Matrix3d(-d.matrix()) : d.matrix();
    add(flip);
    // In the rectilinear frames of both.
    const Eigen::Matrix3d to_frame = second.rectilinear() * second.principal().transpose();
    const Eigen::Matrix3d from_frame = first.principal() * first.rectilinear().transpose();
    add(from_frame * flip * to_frame);
  }
  std::ranges::stable_sort(starts, {}, &Fit::distance);
  Fit best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(kRefined, starts.size()); ++k) {
    Fit fit = starts[k];
    refine(first, second, fit);
    if (measure(first, second, fit, kFine) && fit.distance < best.distance) best = fit;
  }
  measure(first, second, best, 1);
  return best;
}

Fit best_frame(const AlignedShape& first, const AlignedShape& second) {
  const Eigen::Matrix3d to_frame = second.rectilinear() * second.principal().transpose();
  const Eigen::Matrix3d from_frame = first.principal() * first.rectilinear().transpose();
  Fit best;
  best.distance = std::numeric_limits<double>::infinity();
  for (const Rotation& d : frame_symmetries()) {
    Fit fit;
    fit.linear = from_frame * d.matrix() * to_frame;
    if (measure(first, second, fit, kFine) && fit.distance < best.distance) best = fit;
  }
  return best;
}

Placement placement(const AlignedShape& first, const AlignedShape& second, const Fit& fit) {
  Placement result;
  result.linear = first.unit() / second.unit() * first.principal().transpose() * fit.linear * second.principal();
  result.shift =
      first.centre() + first.unit() * (first.principal().transpose() * fit.shift) - result.linear * second.centre();
  return result;
}

VertexFit vertex_fit(const AlignedShape& fine, const AlignedShape& coarse, Fit fit) {
  const std::size_t every = (coarse.vertices().size() + kFineVertices - 1) / kFineVertices;
  double scale = std::max(0.01, fit.distance);
  std::vector<std::uint32_t> last(coarse.vertices().size(), SurfaceTree::kNoGuess);  // triangles that were nearest
  for (int round = 0; round < 30; ++round) {
    Step step;
    std::vector<double> distances;
    for (std::size_t i = 0; i < coarse.vertices().size(); i += every) {
      const Vector3 p = fit.linear * coarse.vertices()[i] + fit.shift;
      const SurfaceTree::Foot foot = fine.tree().nearest(p, kOutOfReach, last[i]);
      last[i] = foot.triangle;
      distances.push_back(std::min(foot.distance, kOutOfReach));
      if (!std::isfinite(foot.distance)) continue;
      const double ratio = foot.distance / scale;
      step.add(fine.tree(), p, foot, 1 / ((1 + ratio * ratio) * (1 + ratio * ratio)));
    }
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    scale = std::clamp(2 * *middle, 1e-4, scale);
    if (step.apply(fit) < kStill) break;
  }
  VertexFit result;
  if (!measure(fine, coarse, fit, 1)) return result;
  result.fit = fit;
  const std::size_t step = (coarse.vertices().size() + kFitVertices - 1) / kFitVertices;
  std::size_t on = 0, count = 0;
  for (std::size_t i = 0; i < coarse.vertices().size(); i += step, ++count)
    on +=
        std::isfinite(fine.vertex_tree().nearest(fit.linear * coarse.vertices()[i] + fit.shift, kSameVertex).distance);
  result.share = static_cast<double>(on) / static_cast<double>(count);
  return result;
}

}  // namespace rectilin::search
