#include "certify/kink_ball.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certify/generator_kernels.h"
#include "rectilin/base/symmetric.h"

namespace rectilin::certification {
namespace {

/// Generators this close to orthogonal to an axis (radians) may be given free signs. One that is not exactly orthogonal
/// costs its |r . v|, so the largest tolerance need not give the largest ball.
constexpr double kBallTolerances[] = {1e-12, 1e-10, 1e-8, 1e-6, 1e-4};
constexpr std::size_t kMostFree = 200, kMostSummands = 24;

/// Rounding error of the cosine of half an angle as Balls computes it: of quaternions, products of four terms, roots.
constexpr double kCosineRounding = 0x1p-48;

/// A generator v nearly orthogonal to axis k (its face is nearly parallel to the axis), with the sign that makes r_k .
/// v nonnegative.
struct FreeGenerator {
  double angle;    // from being orthogonal
  double product;  // r_k . v
  int axis;
  Eigen::Vector3d v;
};

/// Free generators whose moments are parallel, merged into one: they take a common sign.
struct Summand {
  Eigen::Vector3d moment;  // sum of r x v
  Eigen::Matrix3d form;    // sum of r v^T
};

using Extended = Eigen::Matrix<long double, 3, 1>;

/// Divides the generators at a frame, in one pass, into those whose sign is fixed and those that may be free.
struct Split {
  std::array<Extended, 3> settled;
  std::vector<FreeGenerator> free;  // nearest to orthogonal first
  double total = 0;

  Split(const Generators& generators, const Rotation& frame) {
    constexpr double kWidest = std::end(kBallTolerances)[-1];
    const Eigen::Matrix3d& r = frame.matrix();
    const FrameSplit split = split_at(r, generators, kWidest);
    settled = split.others;
    total = split.total;
    for (const std::size_t i : split.near) {
      const Eigen::Vector3d v = generators[i], products = r * v;
      const double length = v.norm();
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d turned = products[k] < 0 ? Eigen::Vector3d(-v) : v;
        const double product = std::abs(products[k]);
        if (product < kWidest * length) free.push_back({product / length, product, k, turned});
        else settled[k] += turned.cast<long double>();
      }
    }
    std::ranges::stable_sort(free, {}, &FreeGenerator::angle);
  }
};

std::vector<Summand> merge_parallel(const Rotation& frame, const std::vector<FreeGenerator>& free, std::size_t count) {
  std::vector<Summand> summands;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d r = frame.axis(free[i].axis), moment = r.cross(free[i].v);
    const Eigen::Matrix3d form = r * free[i].v.transpose();
    const auto same = std::ranges::find_if(summands, [&](const Summand& s) {
      return s.moment.cross(moment).squaredNorm() < 1e-14 * s.moment.squaredNorm() * moment.squaredNorm();
    });
    if (same == summands.end()) {
      summands.push_back({moment, form});
    } else {
      const double sign = same->moment.dot(moment) < 0 ? -1 : 1;
      same->moment += sign * moment;
      same->form += sign * form;
    }
  }
  // Any subset may be kept; the signs of the others then stay zero.
  std::ranges::stable_sort(summands, std::ranges::greater(), [](const Summand& s) { return s.moment.squaredNorm(); });
  if (summands.size() > kMostSummands) summands.resize(kMostSummands);
  return summands;
}

/// A lower bound of the support function of w + sum [-a, a] on unit vectors. If the origin is inside this body, the
/// bound is the radius of the largest ball about it that fits; a facet attains it, and two of the a span the facet.
double least_support(const Eigen::Vector3d& w, const std::vector<Summand>& summands, double rounding) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < summands.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Eigen::Vector3d normal = summands[i].moment.cross(summands[j].moment);
      const double length = normal.norm();
      if (length == 0) return -w.norm() - rounding;
      normal /= length;
      double support = -std::abs(w.dot(normal));
      for (const Summand& s : summands) support += std::abs(normal.dot(s.moment));
      least = std::min(least, support);
    }
  // Moments are merged unless their angle exceeds 1e-7; that leaves 1e-9 of the digits of a normal to rounding.
  least -= 1e-8 * rounding / kBallRounding;
  return summands.size() >= 3 && least > 0 ? least : -w.norm() - rounding;
}

/// The radius of the ball if the first `count` of the free generators are used.
double angle_with(const Split& split, const Rotation& frame, std::size_t count, double value) {
  const double rounding = kBallRounding * split.total;
  std::array<Extended, 3> g = split.settled;
  for (std::size_t i = count; i < split.free.size(); ++i) g[split.free[i].axis] += split.free[i].v.cast<long double>();
  Eigen::Matrix3d form = Eigen::Matrix3d::Zero();  // the matrix B of lemma 2, with the free signs zero
  Eigen::Vector3d w = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d r = frame.axis(k), gk = g[k].cast<double>();
    form += r * gk.transpose();
    w += r.cross(gk);
  }
  const std::vector<Summand> summands = merge_parallel(frame, split.free, count);
  double at_centre = form.trace() - rounding, curvature = form.trace() - symmetric_eigenvalues(form)[0] + rounding;
  for (const Summand& s : summands) {
    at_centre -= std::abs(s.form.trace());
    curvature += std::abs(s.form.trace()) + symmetric_eigenvalues(s.form).cwiseAbs().maxCoeff();
  }
  const double slope = least_support(w, summands, rounding);

  // Solves at_centre + slope sin t - curvature (1 - cos t) >= value, in x = tan(t/2). The solutions begin at x = 0 only
  // if it holds there.
  const double below = value - at_centre, a = 2 * curvature + below, discriminant = slope * slope - below * a;
  if (!(below <= 0 && a > 0 && discriminant > 0)) return 0;
  return 2 * std::atan(std::max(0.0, (slope + std::sqrt(discriminant)) / a));
}

}  // namespace

double kink_ball(const Generators& generators, const Rotation& centre, double value) {
  const Split split(generators, centre);
  double best = 0;
  std::size_t previous = split.free.size() + 1;
  for (const double tolerance : kBallTolerances) {
    const auto end = std::ranges::lower_bound(split.free, tolerance, {}, &FreeGenerator::angle);
    const auto count = static_cast<std::size_t>(end - split.free.begin());
    if (count == previous || count > kMostFree) continue;
    previous = count;
    best = std::max(best, angle_with(split, centre, count, value));
  }
  return std::min(best * (1 - 1e-9), std::numbers::pi / 2 - 1e-3);
}

void Balls::add(const Rotation& centre, double angle) {
  for (const Rotation& symmetry : frame_symmetries()) {
    const Rotation copy = symmetry * centre;
    // No rotation in the zone turns by more than 62.8 degrees, so copies further away are of no use.
    if (angle_between(copy, Rotation()) > 1.1 + angle) continue;
    const Eigen::Quaterniond q = copy.quaternion().normalized();
    balls_.push_back({{q.w(), q.x(), q.y(), q.z()}, std::cos(0.5 * angle) + kCosineRounding});
  }
}

bool Balls::hold(const Box& box) const {
  if (balls_.empty()) return false;
  const Eigen::Vector3d middle = box.centre();
  const double norm = 1 + middle.squaredNorm();
  for (const Ball& ball : balls_) {
    const Eigen::Vector4d& q = ball.quaternion;
    const double product = q[0] + q.tail<3>().dot(middle);
    if (product * product < ball.cosine * ball.cosine * norm) continue;
    // In Rodrigues coordinates the ball is convex (a slice of one nappe of a cone), so it holds the box if it holds
    // the corners.
    const Corners corners(box);
    const Array8 products = q[0] + q[1] * corners.rho[0] + q[2] * corners.rho[1] + q[3] * corners.rho[2];
    const Array8 nearest = product < 0 ? Array8(-products) : products;
    if ((nearest > ball.cosine * corners.norm.sqrt()).all()) return true;
  }
  return false;
}

}  // namespace rectilin::certification
