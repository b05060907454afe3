// The composite pose: of many frames the one with little projected area whose planes are nearly planes of symmetry.
//
//     J = P/P_min + w (F1 + F2)
//
// P is the summed projected area, P_min the least over the candidates, F1 and F2 the smallest mirror defects of the
// frame's three planes. Faces that meet at right angles speak in the first term, symmetry in the second; most objects
// have one plane of symmetry and many have two, a third says more about an object's ends than about its axes.
// Candidates: principal axes, the certified rectilinear pose, and for each of some mirror planes found by search three
// turns about its normal: least projected area of the mesh, the same of its convex hull, principal axes in the plane.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "frames.h"
#include "methods.h"
#include "mirror.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/pose/convex_hull.h"
#include "roundness_of.h"
#include "working_frame.h"

namespace rectilin::pose {
namespace {

constexpr double kSame = 1e-4, kDistinct = 10 * std::numbers::pi / 180;  // radians
constexpr double kRound = 0.02;                                          // bodies of revolution, see unroundness()
constexpr double kUnsure = 0.02;  // a margin of J at which the confidence is one half
constexpr double kTie = 1e-3;     // of J, between distinct frames: what samples can tell
constexpr double kEqual = 1e-9;   // of J, between any frames: what rounding may decide

/// The turn about axis 2 of the frame that makes the in-plane moments diagonal.
Rotation planar_principal_axes(const Surface& surface, const Rotation& frame) {
  const Eigen::Matrix3d m = frame.matrix() * surface.moments * frame.matrix().transpose();
  const double turn = 0.5 * std::atan2(2 * m(0, 1), m(0, 0) - m(1, 1));
  return rotation_from_vector(-turn * Vector3::UnitZ()) * frame;
}

struct Candidates {
  const Surface& surface;
  const MirrorDefect& defect;
  std::vector<PoseCandidate> list = {};

  void add(std::string name, const Rotation& rotation) {
    const auto same = [&](const PoseCandidate& c) { return frame_angle(c.rotation, rotation) < kSame; };
    if (std::ranges::any_of(list, same)) return;
    PoseCandidate candidate;
    candidate.name = std::move(name);
    candidate.rotation = rotation;
    for (int k = 0; k < 3; ++k) candidate.mirror_defects.push_back(defect.through_middle(rotation.axis(k)).defect);
    list.push_back(std::move(candidate));
  }
};

void add_turned(Candidates& candidates, const std::vector<MirrorPlane>& planes, const ProjectedArea& mesh,
                const ProjectedArea& hull) {
  int number = 0;
  for (const MirrorPlane& plane : planes) {
    const Rotation frame = frame_about(plane.normal);
    const std::string name = "mirror " + std::to_string(++number);
    candidates.add(name + ", rectilinear", mesh.best_turn(frame, 2).rotation);
    candidates.add(name + ", hull", hull.best_turn(frame, 2).rotation);
    candidates.add(name + ", pca", planar_principal_axes(candidates.surface, frame));
  }
}

void score(std::vector<PoseCandidate>& list, const ProjectedArea& objective, double weight) {
  double least = std::numeric_limits<double>::infinity();
  for (PoseCandidate& c : list) {
    objective.values({&c.rotation, 1}, {&c.projected, 1});
    least = std::min(least, c.projected);
  }
  for (PoseCandidate& c : list) {
    std::vector<double> f = c.mirror_defects;
    std::ranges::sort(f);
    c.score = c.projected / least + weight * (f[0] + f[1]);
  }
  std::ranges::stable_sort(list, {}, &PoseCandidate::score);
}

/// Are two frames one answer? If the mesh may turn about an axis of the first, all that share this axis are.
bool alike(const Rotation& a, const Rotation& b, int free_axis) {
  if (free_axis < 0) return frame_angle(a, b) <= kDistinct;
  for (int k = 0; k < 3; ++k)
    if (line_angle(a.axis(free_axis), b.axis(k)) <= kDistinct) return true;
  return false;
}

void judge(Pose& pose) {
  const PoseCandidate& best = pose.candidates.front();
  double next = std::numeric_limits<double>::infinity();
  for (const PoseCandidate& c : pose.candidates) {
    if (&c == &best) continue;
    const bool distinct = !alike(best.rotation, c.rotation, pose.free_axis);
    if (distinct) next = std::min(next, c.score);
    const bool round = pose.uniqueness == Uniqueness::kContinuum || pose.uniqueness == Uniqueness::kNone;
    if (round || c.score > best.score + (distinct ? kTie : kEqual)) continue;
    pose.uniqueness = Uniqueness::kSeveral;
    pose.alternatives.push_back(c.rotation);
  }
  const double margin = next - best.score;
  pose.confidence = std::isfinite(margin) ? margin / (margin + kUnsure) : 1;
  if (pose.uniqueness == Uniqueness::kNone) pose.confidence = 0;
  std::vector<double> f = best.mirror_defects;
  std::ranges::sort(f);
  char text[160];
  std::snprintf(text, sizeof text, "J = %.4f with mirror defects %.3f and %.3f, the next frame %.4f", best.score, f[0],
                f[1], next);
  pose.reason = text;
}

}  // namespace

Pose composite_pose(const Surface& given, const CompositeOptions& options) {
  const Rotation work = working_frame(given);
  const Surface surface = turned(given, work);
  const Mesh hull = convex_hull(surface.mesh);
  const MirrorDefect defect(surface, hull);
  const ProjectedArea mesh_area(area_vectors(surface.mesh)), hull_area(area_vectors(hull));

  Candidates candidates{surface, defect};
  candidates.add("rectilinear",
                 rectilinear_pose(surface, {.gap = options.gap, .cells = 20'000, .optima = false}).rotation);
  candidates.add("pca", pca_pose(surface).rotation);
  add_turned(candidates, mirror_planes(defect, static_cast<std::size_t>(options.planes)), mesh_area, hull_area);
  score(candidates.list, mesh_area, options.symmetry);

  Pose pose;
  pose.candidates = std::move(candidates.list);
  choose(pose, 0);
  note_roundness(pose, surface, hull, kRound);
  judge(pose);
  for (PoseCandidate& c : pose.candidates) c.rotation = c.rotation * work;
  for (Rotation& r : pose.alternatives) r = r * work;
  choose(pose, 0);
  return pose;
}

}  // namespace rectilin::pose
