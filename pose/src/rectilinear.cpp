// The certified optimum of R: of the mesh, and of its convex hull.
#include <algorithm>
#include <limits>

#include "frames.h"
#include "methods.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/optim/certify.h"
#include "rectilin/pose/convex_hull.h"

namespace rectilin::pose {
namespace {

/// The axis of the frame that stays when a continuum of optima is walked along: the one the others share with it.
int shared_axis(const Rotation& a, const Rotation& b) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      if (const double angle = line_angle(a.axis(k), b.axis(j)); angle < least) least = angle, best = k;
  return best;
}

/// Does turning about the axis by any angle cost less than `gap` of the value?
bool free_about(const ProjectedArea& objective, const Rotation& frame, int axis, double most) {
  for (const double turn : {0.1, 0.3, 0.5, 0.7, 1.1, 1.3}) {
    const Rotation turned = rotation_from_vector(turn * Vector3::Unit(axis)) * frame;
    double value = 0;
    objective.values({&turned, 1}, {&value, 1});
    if (value > most) return false;
  }
  return true;
}

Pose certified(const ProjectedArea& objective, const CertifiedOptions& options, const std::string& name) {
  Evaluator evaluator(objective);
  CertifyOptions settings;
  settings.gap = options.gap;
  settings.cells = options.cells;
  settings.optima = options.optima;
  const CertifyResult result = certify(evaluator, settings);
  Pose pose = single(name, result.incumbent.rotation);
  pose.candidates.front().score = result.incumbent.value;
  char text[96];
  std::snprintf(text, sizeof text, "R = %.6f, at most %.6f in any pose", objective.merit(result.incumbent.value),
                objective.merit(result.lower));
  pose.reason = text;
  // A body of revolution in finely many facets has a continuum of poses within their size.
  const double most = result.incumbent.value * (1 + 1e-3);
  int free = 0;
  for (int k = 0; k < 3; ++k)
    if (free_about(objective, pose.rotation, k, most)) ++free, pose.free_axis = k;
  if (free > 1) {
    pose.uniqueness = Uniqueness::kNone;
    pose.free_axis = -1;
  } else if (free == 1) {
    pose.uniqueness = Uniqueness::kContinuum;
  } else {
    for (const Optimum& optimum : result.optima) {
      if (frame_angle(optimum.rotation, pose.rotation) < 1e-3) {
        if (optimum.kind == Optimum::Kind::kContinuum) pose.uniqueness = Uniqueness::kContinuum;
        continue;
      }
      if (optimum.kind == Optimum::Kind::kPossible) continue;
      if (pose.uniqueness == Uniqueness::kUnique) pose.uniqueness = Uniqueness::kSeveral;
      pose.alternatives.push_back(optimum.rotation);
    }
    if (pose.uniqueness == Uniqueness::kContinuum)
      pose.free_axis = pose.alternatives.empty() ? 2 : shared_axis(pose.rotation, pose.alternatives.front());
  }
  return pose;
}

}  // namespace

Pose rectilinear_pose(const Surface& surface, const CertifiedOptions& options) {
  return certified(ProjectedArea(area_vectors(surface.mesh)), options, "rectilinear");
}

Pose hull_pose(const Surface& surface, const CertifiedOptions& options) {
  return certified(ProjectedArea(area_vectors(convex_hull(surface.mesh))), options, "hull");
}

}  // namespace rectilin::pose
