#include "rectilin/render/silhouette_area.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "silhouette/contours.h"

namespace rectilin::render {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Scaled first, so that no length overflows or vanishes.
Vector3 unit_vector(const Vector3& direction) {
  const double size = direction.lpNorm<Eigen::Infinity>();
  if (!direction.allFinite() || size == 0) throw std::invalid_argument("a direction is finite and not zero");
  const int exponent = -std::ilogb(size);
  const Vector3 scaled(std::scalbn(direction.x(), exponent), std::scalbn(direction.y(), exponent),
                       std::scalbn(direction.z(), exponent));
  return scaled.normalized();
}

/// An interval in the mesh's unit, rounded outward; areas beyond double precision are between the greatest number and
/// infinity, or between zero and the least.
AreaInterval scaled(double lower, double upper, int exponent) {
  lower = std::scalbn(std::max(0.0, std::nextafter(lower, 0)), 2 * exponent);
  upper = std::scalbn(std::nextafter(upper, kInfinity), 2 * exponent);
  return {std::min(std::nextafter(lower, 0), std::numeric_limits<double>::max()), std::nextafter(upper, kInfinity)};
}

}  // namespace

Silhouette::Silhouette(const Mesh& mesh) : contours_(std::make_unique<const Contours>(mesh)) {}
Silhouette::~Silhouette() = default;
Silhouette::Silhouette(Silhouette&&) noexcept = default;
Silhouette& Silhouette::operator=(Silhouette&&) noexcept = default;

AreaInterval Silhouette::area(const Vector3& direction, double tolerance) const {
  if (!(tolerance >= 0 && tolerance <= 1)) throw std::invalid_argument("a tolerance is from 0 to 1");
  const Contours::Picture picture = contours_->seen_along(unit_vector(direction));
  const CoveredArea covered = covered_area(picture.edges, 0.999 * tolerance);  // the rest is for rounding
  const double slack = picture.slack + covered.slack;
  if (covered.area + covered.open + slack == 0) return {0, 0};
  return scaled(covered.area - slack, covered.area + covered.open + slack, contours_->exponent());
}

std::vector<AreaInterval> Silhouette::areas(std::span<const Vector3> directions, double tolerance) const {
  std::vector<AreaInterval> intervals(directions.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, directions.size(), 1), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) intervals[i] = area(directions[i], tolerance);
  });
  return intervals;
}

AreaInterval silhouette_area(const Mesh& mesh, const Vector3& direction, double tolerance) {
  return Silhouette(mesh).area(direction, tolerance);
}

}  // namespace rectilin::render
