// The composite pose: of many frames the one with little projected area whose planes are nearly planes of symmetry and
// one of whose axes goes through a flat side.
//
//     J = P/P_min + w (f(F1) + f(F2)) - v B,   f(F) = sqrt(F + 0.01)
//
// P is the summed projected area, P_min the least over the candidates, F1 and F2 the smallest mirror defects of the
// frame's three planes, B the largest share of the hull's outline along an axis that is flat. Faces that meet at right
// angles speak in the first term, symmetry in the second; most objects have one plane of symmetry and many have two, a
// third says more about an object's ends than about its axes. Defects are squares of distances, hence the root; what is
// added keeps samples from deciding between planes that are both nearly perfect. The third term is the ground that most
// objects stand on.
// Candidates: principal axes, the certified rectilinear pose, and for each of some mirror planes and flat sides found
// by search three turns about its normal: least projected area of the mesh, the same of its convex hull, principal axes
// in the plane.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bases.h"
#include "frames.h"
#include "methods.h"
#include "mirror.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/pose/convex_hull.h"
#include "roundness_of.h"

namespace rectilin::pose {
namespace {

constexpr double kSame = 1e-4, kDistinct = 10 * std::numbers::pi / 180;  // radians
constexpr double kRound = 0.02;                                          // bodies of revolution, see unroundness()
constexpr double kUnsure = 0.02;   // a margin of J at which the confidence is one half
constexpr double kSamples = 0.01;  // of a mirror defect: below, samples decide
constexpr std::size_t kSides = 4;  // flat sides that frames are made from
constexpr double kTie = 3e-3;      // of J, between distinct frames: what samples can tell
constexpr double kEqual = 1e-9;    // of J, between any frames: what rounding may decide
constexpr double kNear = std::numbers::pi / 180;
const std::string kCertified = "rectilinear";

/// The turn about axis 2 of the frame that makes the in-plane moments diagonal.
Rotation planar_principal_axes(const Surface& surface, const Rotation& frame) {
  const Eigen::Matrix3d m = frame.matrix() * surface.moments * frame.matrix().transpose();
  const double turn = 0.5 * std::atan2(2 * m(0, 1), m(0, 0) - m(1, 1));
  return rotation_from_vector(-turn * Vector3::UnitZ()) * frame;
}

struct Candidates {
  const Surface& surface;
  const MirrorDefect& defect;
  const Bases& bases;
  std::vector<PoseCandidate> list = {};

  void add(std::string name, const Rotation& rotation) {
    const auto same = [&](const PoseCandidate& c) { return frame_angle(c.rotation, rotation) < kSame; };
    if (std::ranges::any_of(list, same)) return;
    PoseCandidate candidate;
    candidate.name = std::move(name);
    candidate.rotation = rotation;
    candidate.flat_share = 0;
    for (int k = 0; k < 3; ++k) {
      candidate.mirror_defects.push_back(defect.through_middle(rotation.axis(k)).defect);
      candidate.flat_share = std::max(*candidate.flat_share, bases.share(rotation.axis(k)));
    }
    list.push_back(std::move(candidate));
  }
};

void add_turned(Candidates& candidates, const std::string& name, const std::vector<Vector3>& normals,
                const ProjectedArea& mesh, const ProjectedArea& hull) {
  int number = 0;
  for (const Vector3& normal : normals) {
    const Rotation frame = frame_about(normal);
    const std::string numbered = name + " " + std::to_string(++number);
    candidates.add(numbered + ", rectilinear", mesh.best_turn(frame, 2).rotation);
    candidates.add(numbered + ", hull", hull.best_turn(frame, 2).rotation);
    candidates.add(numbered + ", pca", planar_principal_axes(candidates.surface, frame));
  }
}

std::vector<Vector3> normals_of(const std::vector<MirrorPlane>& planes) {
  std::vector<Vector3> normals;
  for (const MirrorPlane& plane : planes) normals.push_back(plane.normal);
  return normals;
}

void score(std::vector<PoseCandidate>& list, const ProjectedArea& objective, const CompositeOptions& options) {
  const auto softened = [](double defect) { return std::sqrt(defect + kSamples); };
  double least = std::numeric_limits<double>::infinity();
  for (PoseCandidate& c : list) {
    objective.values({&c.rotation, 1}, {&c.projected, 1});
    least = std::min(least, c.projected);
  }
  for (PoseCandidate& c : list) {
    std::vector<double> f = c.mirror_defects;
    std::ranges::sort(f);
    c.score = c.projected / least + options.symmetry * (softened(f[0]) + softened(f[1])) - options.flat * *c.flat_share;
  }
  std::ranges::stable_sort(list, {}, &PoseCandidate::score);
  // Of near frames that samples cannot tell apart the certified one is taken, which is the same after any turn.
  const auto certified = std::ranges::find(list, kCertified, &PoseCandidate::name);
  if (certified->score <= list.front().score + kTie && frame_angle(certified->rotation, list.front().rotation) < kNear)
    std::rotate(list.begin(), certified, certified + 1);
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
    if (best.name == kCertified && frame_angle(c.rotation, best.rotation) < kNear) continue;
    pose.uniqueness = Uniqueness::kSeveral;
    pose.alternatives.push_back(c.rotation);
  }
  const double margin = next - best.score;
  pose.confidence = std::isfinite(margin) ? margin / (margin + kUnsure) : 1;
  if (pose.uniqueness == Uniqueness::kNone) pose.confidence = 0;
  std::vector<double> f = best.mirror_defects;
  std::ranges::sort(f);
  char text[160];
  std::snprintf(text, sizeof text,
                "J = %.4f with mirror defects %.3f and %.3f, %.2f of a side flat; the next frame %.4f", best.score,
                f[0], f[1], best.flat_share.value_or(0), next);
  pose.reason = text;
}

}  // namespace

Pose composite_pose(const Surface& surface, const CompositeOptions& options) {
  const Mesh hull = convex_hull(surface.mesh);
  const MirrorDefect defect(surface, hull);
  const ProjectedArea mesh_area(area_vectors(surface.mesh)), hull_area(area_vectors(hull));

  const Bases bases(hull);
  Candidates candidates{surface, defect, bases};
  const Pose rectilinear = rectilinear_pose(surface, {.gap = options.gap, .cells = 20'000});
  candidates.add(kCertified, rectilinear.rotation);
  int number = 1;
  for (const Rotation& rotation : rectilinear.alternatives)
    candidates.add(kCertified + " " + std::to_string(++number), rotation);
  candidates.add("pca", pca_pose(surface).rotation);
  const std::vector<MirrorPlane> planes = mirror_planes(defect, static_cast<std::size_t>(options.planes));
  add_turned(candidates, "mirror", normals_of(planes), mesh_area, hull_area);
  add_turned(candidates, "side", bases.flattest(kSides), mesh_area, hull_area);
  score(candidates.list, mesh_area, options);

  Pose pose;
  pose.candidates = std::move(candidates.list);
  choose(pose, 0);
  note_roundness(pose, surface, hull, kRound);
  judge(pose);
  return pose;
}

}  // namespace rectilin::pose
