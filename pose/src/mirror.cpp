#include "mirror.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "frames.h"
#include "rectilin/base/symmetric.h"

namespace rectilin::pose {
namespace {

constexpr double kWidth = 0.09;                                     // of the root mean square radius
constexpr std::size_t kTargets = 8000, kFine = 800, kCoarse = 250;  // samples
constexpr int kDirections = 1000;                                   // of the scan: about 5 degrees apart
constexpr double kApart = 5 * std::numbers::pi / 180;
// Of polishing: rounds, how much worse the defect may become, and how far the normal may turn.
constexpr int kRounds = 12;
constexpr double kAllowed = 0.005, kStray = 2 * std::numbers::pi / 180;

/// Pattern search in tilt (two angles) and offset.
MirrorPlane refined(const MirrorDefect& defect, MirrorPlane plane) {
  plane.defect = defect.of(plane.normal, plane.offset);
  const double unit = defect.width() / 0.09;
  for (double step = 0.04; step > 2e-4;) {
    const Vector3 first = plane.normal.unitOrthogonal(), second = plane.normal.cross(first);
    MirrorPlane best = plane;
    const auto offer = [&](const Vector3& normal, double offset) {
      const double found = defect.of(normal, offset);
      if (found < best.defect) best = {normal, offset, found};
    };
    for (const double sign : {step, -step}) {
      offer((plane.normal + sign * first).normalized(), plane.offset);
      offer((plane.normal + sign * second).normalized(), plane.offset);
      offer(plane.normal, plane.offset + sign * unit);
    }
    if (best.defect < plane.defect) plane = best;
    else step /= 2;
  }
  return plane;
}

}  // namespace

MirrorDefect::MirrorDefect(const Surface& surface, const Mesh& hull)
    : width_(kWidth * surface.rms),
      field_(sample_surface(surface, kTargets), width_),
      fine_(sample_surface(surface, kFine)),
      coarse_(sample_surface(surface, kCoarse)),
      outline_(hull.vertices) {}

double MirrorDefect::measure(const Samples& samples, const Vector3& normal, double offset) const {
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vector3 point = samples.points[i] - 2 * (normal.dot(samples.points[i]) - offset) * normal;
    const Vector3 turned = samples.normals[i] - 2 * normal.dot(samples.normals[i]) * normal;
    sum += field_.likeness(point, turned);
  }
  return 1 - sum / static_cast<double>(samples.size());
}

double MirrorDefect::middle_of_extent(const Vector3& normal) const {
  double lower = outline_.front().dot(normal), upper = lower;
  for (const Vector3& v : outline_) {
    const double x = v.dot(normal);
    lower = std::min(lower, x);
    upper = std::max(upper, x);
  }
  return (lower + upper) / 2;
}

MirrorPlane MirrorDefect::through_middle(const Vector3& normal) const {
  const double middle = middle_of_extent(normal);
  const double a = of(normal, 0), b = of(normal, middle);
  return a <= b ? MirrorPlane{normal, 0, a} : MirrorPlane{normal, middle, b};
}

MirrorPlane MirrorDefect::polished(MirrorPlane plane) const {
  const MirrorPlane start = plane;
  double scale = width_ / 2;
  for (int round = 0; round < kRounds; ++round, scale = std::max(scale / 2, width_ * 1e-3)) {
    const Vector3 first = plane.normal.unitOrthogonal(), second = plane.normal.cross(first);
    Eigen::Matrix3d squares = Eigen::Matrix3d::Identity() * 1e-12;
    Vector3 right = Vector3::Zero();
    for (std::size_t i = 0; i < fine_.size(); ++i) {
      const Vector3& p = fine_.points[i];
      const double height = plane.normal.dot(p) - plane.offset;
      const Vector3 point = p - 2 * height * plane.normal;
      const Vector3 turned = fine_.normals[i] - 2 * plane.normal.dot(fine_.normals[i]) * plane.normal;
      const auto match = field_.match(point, turned);
      if (!match) continue;
      const Vector3& m = field_.samples().normals[*match];
      const double apart = (point - field_.samples().points[*match]).dot(m);
      const double alike = m.dot(turned);
      const double weight = alike * alike * alike * alike / (1 + (apart / scale) * (apart / scale));
      // Tilting the normal by a in the direction t moves the image by -2a ((t . p) n + height t), raising the offset
      // by b moves it by 2b n.
      const auto tilt = [&](const Vector3& t) { return -2 * (t.dot(p) * plane.normal.dot(m) + height * t.dot(m)); };
      const Vector3 row(tilt(first), tilt(second), 2 * plane.normal.dot(m));
      squares += weight * row * row.transpose();
      right -= weight * apart * row;
    }
    const Vector3 step = solve_symmetric(squares, right);
    if (!step.allFinite()) return start;
    plane.normal = (plane.normal + step[0] * first + step[1] * second).normalized();
    plane.offset += step[2];
  }
  plane.defect = of(plane.normal, plane.offset);
  const bool better =
      plane.defect < start.defect + kAllowed && std::abs(plane.normal.dot(start.normal)) > std::cos(kStray);
  return better ? plane : start;
}

std::vector<MirrorPlane> mirror_planes(const MirrorDefect& defect, std::size_t count) {
  std::vector<MirrorPlane> scanned;
  for (int i = 0; i < kDirections; ++i) {
    const Vector3 normal = hemisphere_point(i, kDirections);
    MirrorPlane best{normal, 0, defect.roughly(normal, 0)};
    const double middle = defect.middle_of_extent(normal), there = defect.roughly(normal, middle);
    if (there < best.defect) best = {normal, middle, there};
    scanned.push_back(best);
  }
  std::ranges::stable_sort(scanned, {}, &MirrorPlane::defect);
  const auto apart_from = [](const std::vector<MirrorPlane>& planes, const Vector3& normal, double angle) {
    return std::ranges::none_of(planes,
                                [&](const MirrorPlane& p) { return std::abs(p.normal.dot(normal)) > std::cos(angle); });
  };
  std::vector<MirrorPlane> starts, planes;
  for (const MirrorPlane& plane : scanned) {
    if (starts.size() == 2 * count) break;
    if (apart_from(starts, plane.normal, 2 * kApart)) starts.push_back(plane);
  }
  for (MirrorPlane& plane : starts) plane = defect.polished(refined(defect, plane));
  std::ranges::stable_sort(starts, {}, &MirrorPlane::defect);
  for (const MirrorPlane& plane : starts)
    if (planes.size() < count && apart_from(planes, plane.normal, kApart)) planes.push_back(plane);
  return planes;
}

}  // namespace rectilin::pose
