// Poses by symmetry: an axis of revolution if there is one, else the best mirror plane.
#include <algorithm>
#include <cstdio>

#include "frames.h"
#include "methods.h"
#include "mirror.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/pose/convex_hull.h"
#include "roundness_of.h"

namespace rectilin::pose {
namespace {

constexpr double kRoundBody = 0.05;  // see unroundness()

/// The principal axis about which the mesh is nearest to a body of revolution: all such bodies turn about one.
std::pair<int, double> roundest_axis(const Surface& surface, const Mesh& hull, const Rotation& principal) {
  std::pair<int, double> best{-1, 1};
  for (int k = 0; k < 3; ++k)
    if (const double found = unroundness(surface, hull, principal.axis(k)); found < best.second) best = {k, found};
  return best;
}

}  // namespace

Pose symmetry_pose(const Surface& surface, const SymmetryOptions& options) {
  const Mesh hull = convex_hull(surface.mesh);
  const ProjectedArea objective(area_vectors(surface.mesh));
  const MirrorDefect defect(surface, hull);

  Pose pose;
  const auto add = [&](const std::string& name, const Vector3& axis, double score) {
    PoseCandidate candidate;
    candidate.name = name;
    candidate.rotation = objective.best_turn(frame_about(axis), 2).rotation;
    for (int k = 0; k < 3; ++k)
      candidate.mirror_defects.push_back(defect.through_middle(candidate.rotation.axis(k)).defect);
    candidate.score = score;
    pose.candidates.push_back(std::move(candidate));
  };
  const Rotation principal = pca_pose(surface).rotation;
  const auto [axis, unround] = roundest_axis(surface, hull, principal);
  const bool round = unround < kRoundBody;
  if (round) add("axis of revolution", principal.axis(axis), unround);
  for (const MirrorPlane& plane : mirror_planes(defect, static_cast<std::size_t>(options.planes)))
    add("mirror plane", plane.normal, plane.defect);
  choose(pose, 0);
  char text[96];
  std::snprintf(text, sizeof text, "%s with a defect of %.4f", pose.chosen.c_str(), pose.candidates.front().score);
  pose.reason = text;
  note_roundness(pose, surface, hull, kRoundBody);
  if (!round && pose.candidates.size() > 1) {
    const double margin = pose.candidates[1].score - pose.candidates[0].score;
    pose.confidence = margin / (margin + 0.1);
  }
  return pose;
}

}  // namespace rectilin::pose
