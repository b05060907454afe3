#include "near_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rectilin::pose {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr double kAnother = 0.9;   // normals with a smaller product face another way: more than 25 degrees apart
constexpr int kReach = 3;          // in widths
constexpr double kPerWidth = 1.5;  // cells

/// Cells round a sample, as far as it may matter.
struct Step {
  int x, y, z;
};
std::vector<Step> ball(double radius) {
  std::vector<Step> steps;
  const int r = static_cast<int>(std::ceil(radius));
  for (int z = -r; z <= r; ++z)
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x)
        if (x * x + y * y + z * z <= radius * radius) steps.push_back({x, y, z});
  return steps;
}

}  // namespace

NearField::NearField(Samples samples, double width)
    : samples_(std::move(samples)), width_(width), cell_size_(width / kPerWidth) {
  Vector3 lower = samples_.points.front(), upper = lower;
  for (const Vector3& p : samples_.points) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const int margin = static_cast<int>(std::ceil(kReach * kPerWidth)) + 1;
  for (int k = 0; k < 3; ++k) {
    const double length = std::max((upper[k] - lower[k]) / cell_size_, 0.0);
    counts_[k] = static_cast<int>(length) + 2 + 2 * margin;
    // Faces across an axis must not lie on the border between cells, where rounding decides.
    origin_[k] = lower[k] - (margin + 0.381966) * cell_size_;
  }
  const std::size_t total = static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2];
  pairs_.assign(total, {kNone, kNone});
  struct Squares {
    float nearest = std::numeric_limits<float>::max(), other = std::numeric_limits<float>::max();
  };
  std::vector<Squares> squares(total);
  const std::vector<Step> steps = ball(kReach * kPerWidth);
  for (std::uint32_t i = 0; i < samples_.size(); ++i) {
    const Vector3 at = (samples_.points[i] - origin_) / cell_size_;
    const int x = static_cast<int>(at[0]), y = static_cast<int>(at[1]), z = static_cast<int>(at[2]);
    const float fx = static_cast<float>(x + 0.5 - at[0]), fy = static_cast<float>(y + 0.5 - at[1]),
                fz = static_cast<float>(z + 0.5 - at[2]);
    const auto faces_another_way = [&](std::uint32_t j) {
      return std::abs(samples_.normals[i].dot(samples_.normals[j])) < kAnother;
    };
    for (const Step& step : steps) {
      const float dx = fx + static_cast<float>(step.x), dy = fy + static_cast<float>(step.y),
                  dz = fz + static_cast<float>(step.z);
      const float square = dx * dx + dy * dy + dz * dz;
      const std::size_t c = cell(x + step.x, y + step.y, z + step.z);
      Pair& known = pairs_[c];
      Squares& apart = squares[c];
      if (square >= apart.other) continue;
      if (square < apart.nearest) {
        if (known.nearest != kNone && faces_another_way(known.nearest)) {
          known.other = known.nearest;
          apart.other = apart.nearest;
        }
        known.nearest = i;
        apart.nearest = square;
      } else if (faces_another_way(known.nearest)) {
        known.other = i;
        apart.other = square;
      }
    }
  }
}

const NearField::Pair* NearField::at(const Vector3& point) const {
  const Vector3 at = (point - origin_) / cell_size_;
  for (int k = 0; k < 3; ++k)
    if (!(at[k] >= 0 && at[k] < counts_[k])) return nullptr;
  const Pair& known = pairs_[cell(static_cast<int>(at[0]), static_cast<int>(at[1]), static_cast<int>(at[2]))];
  return known.nearest == kNone ? nullptr : &known;
}

double NearField::likeness(std::uint32_t sample, const Vector3& point, const Vector3& normal) const {
  const Vector3 apart = point - samples_.points[sample];
  const double above = apart.dot(samples_.normals[sample]);
  const double beside = std::sqrt(std::max(apart.squaredNorm() - above * above, 0.0)) - samples_.patch;
  const double square = above * above + (beside > 0 ? beside * beside : 0);
  const double alike = normal.dot(samples_.normals[sample]);
  return std::exp(-square / (2 * width_ * width_)) * alike * alike;
}

double NearField::likeness(const Vector3& point, const Vector3& normal) const {
  const Pair* known = at(point);
  if (!known) return 0;
  const double nearest = likeness(known->nearest, point, normal);
  return known->other == kNone ? nearest : std::max(nearest, likeness(known->other, point, normal));
}

std::optional<std::size_t> NearField::match(const Vector3& point, const Vector3& normal) const {
  const Pair* known = at(point);
  if (!known) return std::nullopt;
  const bool other =
      known->other != kNone && likeness(known->other, point, normal) > likeness(known->nearest, point, normal);
  return other ? known->other : known->nearest;
}

}  // namespace rectilin::pose
