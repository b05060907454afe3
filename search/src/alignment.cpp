#include "alignment.h"

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rectilin/base/rotation.h"

namespace rectilin::search {
namespace {

constexpr std::size_t kFitSamples = 2000;  // of a surface
constexpr std::size_t kCoarse = 10;        // every so many decide which turns are worth refining
constexpr std::size_t kFine = 2;           // every so many are used to refine
constexpr std::size_t kRefined = 3;        // turns that are
constexpr int kRounds = 20;

/// The point of a triangle nearest to p (Ericson 2004, section 5.1.5).
Vector3 nearest_of_triangle(const Vector3& p, const std::array<Vector3, 3>& t) {
  const Vector3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const Vector3 bp = p - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + d1 / (d1 - d3) * ab;
  const Vector3 cp = p - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return t[1] + (d4 - d3) / (d4 - d3 + d5 - d6) * (t[2] - t[1]);
  const double sum = va + vb + vc;
  return sum > 0 ? Vector3(t[0] + vb / sum * ab + vc / sum * ac) : t[0];
}

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
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second);
  for (int k = 0; k < 3; ++k) {
    principal_.row(k) = solver.eigenvectors().col(2 - k).transpose();
    moments_(k) = solver.eigenvalues()(2 - k) / second.trace();
  }
  if (principal_.determinant() < 0) principal_.row(2) *= -1;
  rectilinear_ = model.frame("rectilinear").rotation.matrix();
  unit_ = rms / frame.scale;
  disc_ = 1.5 * std::sqrt(area / (rms * rms) / (std::numbers::pi * kFitSamples));

  for (const Triangle& t : mesh.triangles)
    triangles_.push_back({principal_ * mesh.vertices[t[0]] / rms, principal_ * mesh.vertices[t[1]] / rms,
                          principal_ * mesh.vertices[t[2]] / rms});
  std::size_t triangle = 0;
  for (std::size_t k = 0; k < kFitSamples; ++k) {
    const double at = area * (static_cast<double>(k) + 0.5) / kFitSamples;
    while (triangle + 1 < ends.size() && ends[triangle] < at) ++triangle;
    // Roberts's sequence fills the triangle evenly.
    double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(k), 1.0);
    double v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(k), 1.0);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto& t = triangles_[triangle];
    samples_.push_back({t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]), (t[1] - t[0]).cross(t[2] - t[0]).normalized(),
                        static_cast<std::uint32_t>(triangle)});
  }

  cell_ = 0.15;
  low_ = samples_[0].point;
  Vector3 high = low_;
  for (const Sample& s : samples_) {
    low_ = low_.cwiseMin(s.point);
    high = high.cwiseMax(s.point);
  }
  cell_ = std::max(cell_, (high - low_).maxCoeff() / 100);
  for (int k = 0; k < 3; ++k) counts_[static_cast<std::size_t>(k)] = static_cast<int>((high - low_)(k) / cell_) + 1;
  const auto cells = static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]) *
                     static_cast<std::size_t>(counts_[2]);
  begins_.assign(cells + 1, 0);
  for (const Sample& s : samples_) ++begins_[cell_of(s.point, {}) + 1];
  for (std::size_t i = 0; i < cells; ++i) begins_[i + 1] += begins_[i];
  order_.resize(samples_.size());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t i = 0; i < samples_.size(); ++i) order_[next[cell_of(samples_[i].point, {})]++] = i;
}

/// The cell so many steps from that of a point; the number of cells if there is none.
std::size_t AlignedShape::cell_of(const Vector3& p, const std::array<int, 3>& step) const {
  std::array<int, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = std::floor((p(static_cast<int>(k)) - low_(static_cast<int>(k))) / cell_);
    at[k] = static_cast<int>(std::clamp(x, -2.0, counts_[k] + 1.0)) + step[k];
    if (at[k] < 0 || at[k] >= counts_[k]) return begins_.empty() ? 0 : begins_.size() - 1;
  }
  return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(counts_[1]) + static_cast<std::size_t>(at[1])) *
             static_cast<std::size_t>(counts_[0]) +
         static_cast<std::size_t>(at[0]);
}

AlignedShape::Foot AlignedShape::nearest(const Vector3& p) const {
  // The nearest samples, each of another triangle, from the cells around.
  std::array<std::pair<double, std::uint32_t>, 3> best;
  best.fill({std::numeric_limits<double>::infinity(), 0});
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const std::size_t cell = cell_of(p, {x, y, z});
        if (cell + 1 >= begins_.size()) continue;
        for (std::uint32_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
          const Sample& s = samples_[order_[i]];
          const double d = (s.point - p).squaredNorm();
          if (d >= best[2].first) continue;
          std::size_t at = 2;  // where its triangle is already, else last
          for (std::size_t k = 0; k < 3; ++k)
            if (std::isfinite(best[k].first) && samples_[best[k].second].triangle == s.triangle) at = k;
          if (d >= best[at].first) continue;
          best[at] = {d, order_[i]};
          std::ranges::sort(best);
        }
      }
  Foot foot{p, Vector3::Zero(), std::numeric_limits<double>::infinity()};
  for (const auto& [d, i] : best) {
    if (!std::isfinite(d)) continue;
    const Vector3 q = nearest_of_triangle(p, triangles_[samples_[i].triangle]);
    const double distance = (q - p).norm();
    if (distance < foot.distance) foot = {q, samples_[i].normal, distance};
    // Most triangles of a fine mesh have no sample: a sample stands for a flat disc of its share of the surface, too.
    const Sample& s = samples_[i];
    Vector3 aside = p - s.point;
    aside -= s.normal.dot(aside) * s.normal;
    const double length = aside.norm();
    if (length > disc_) aside *= disc_ / length;
    const Vector3 on_disc = s.point + aside;
    const double from_disc = (on_disc - p).norm();
    if (from_disc < foot.distance) foot = {on_disc, s.normal, from_disc};
  }
  return foot;
}

namespace {

constexpr double kOutOfReach = 0.3;  // what a sample without a foot counts for

double one_sided(const AlignedShape& surface, const AlignedShape& samples, const Eigen::Matrix3d& linear,
                 const Vector3& shift, std::size_t every) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.samples().size(); i += every) {
    const double d = std::min(kOutOfReach, surface.nearest(linear * samples.samples()[i].point + shift).distance);
    sum += d * d;
    ++count;
  }
  return sum / static_cast<double>(count);
}

/// One step of the iterative closest point method with distances from planes (Chen and Medioni 1992), turn, shift and
/// scale together.
void refine(const AlignedShape& first, const AlignedShape& second, Fit& fit) {
  Eigen::Matrix<double, 7, 7> normal = Eigen::Matrix<double, 7, 7>::Zero();
  Eigen::Matrix<double, 7, 1> right = Eigen::Matrix<double, 7, 1>::Zero();
  for (std::size_t i = 0; i < second.samples().size(); i += kFine) {
    const Vector3 p = fit.linear * second.samples()[i].point + fit.shift;
    const AlignedShape::Foot foot = first.nearest(p);
    if (!(foot.distance < kOutOfReach / 2)) continue;
    // At edges the way to the foot is no normal of the triangle; it is what is left to go all the same.
    const Vector3 n = foot.distance > 1e-9 ? Vector3((p - foot.point) / foot.distance) : foot.normal;
    Eigen::Matrix<double, 7, 1> row;
    row << p.cross(n), n, p.dot(n);
    normal += row * row.transpose();
    right -= row * foot.distance;
  }
  normal.diagonal().array() += 1e-6 * normal.trace();
  const Eigen::Matrix<double, 7, 1> step = normal.ldlt().solve(right);
  if (!step.allFinite()) return;
  const Eigen::Matrix3d turn = rotation_from_vector(step.head<3>()).matrix() * (1 + std::clamp(step(6), -0.1, 0.1));
  fit.linear = turn * fit.linear;
  fit.shift = turn * fit.shift + step.segment<3>(3);
}

}  // namespace

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
    for (int round = 0; round < kRounds; ++round) refine(first, second, fit);
    if (!(std::abs(fit.linear.determinant()) > 0.01)) continue;
    const Eigen::Matrix3d back = fit.linear.inverse();
    const double scale = std::cbrt(std::abs(fit.linear.determinant()));
    const double there = one_sided(first, second, fit.linear, fit.shift, 1);
    const double home = one_sided(second, first, back, -back * fit.shift, 1) * scale * scale;
    fit.distance = std::sqrt((there + home) / 2);
    if (fit.distance < best.distance) best = fit;
  }
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
    fit.distance = std::sqrt((one_sided(first, second, fit.linear, fit.shift, kFine) +
                              one_sided(second, first, fit.linear.transpose(), fit.shift, kFine)) /
                             2);
    if (fit.distance < best.distance) best = fit;
  }
  return best;
}

}  // namespace rectilin::search
