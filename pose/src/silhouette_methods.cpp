// Poses by silhouettes: the paper's choice between two, and a search for the least.
#include <algorithm>
#include <cstdio>

#include "frames.h"
#include "methods.h"
#include "rectilin/optim/registry.h"
#include "rectilin/optim/run_record.h"
#include "rectilin/pose/convex_hull.h"
#include "rectilin/pose/summed_silhouette.h"
#include "rectilin/render/rasterizer.h"
#include "roundness_of.h"

namespace rectilin::pose {
namespace {

using render::AreaInterval;

/// Silhouette pixels in three pictures that the ball through the furthest corner just fits, as a share of the area.
double pixel_area(const Surface& surface, const Rotation& frame, int size) {
  render::ViewRenderer renderer(surface.mesh, {Vector3::Zero(), surface.radius}, {.size = size});
  std::size_t pixels = 0;
  for (int k = 0; k < 3; ++k) {
    const int order[3] = {(k + 1) % 3, (k + 2) % 3, k};
    Eigen::Matrix3d rows;
    for (int j = 0; j < 3; ++j) rows.row(j) = frame.matrix().row(order[j]);
    pixels += renderer.render(Rotation::from_matrix(rows)).covered_pixels();
  }
  const double edge = 2 * surface.radius / size;
  return static_cast<double>(pixels) * edge * edge / surface.area;
}

std::string two_figures(const char* format, double a, double b) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// Sums of areas narrow enough to be told apart, or to say that they are equal to a millionth.
std::pair<AreaInterval, AreaInterval> told_apart(const SummedSilhouette& silhouette, const Rotation& a,
                                                 const Rotation& b) {
  std::pair<AreaInterval, AreaInterval> areas;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    areas = {silhouette.interval(a, tolerance), silhouette.interval(b, tolerance)};
    if (areas.first.upper < areas.second.lower || areas.second.upper < areas.first.lower) break;
  }
  return areas;
}

double middle(const AreaInterval& interval) { return (interval.lower + interval.upper) / 2; }

/// The pose's uniqueness is that of the method chosen.
void inherit(Pose& pose, const Pose& from) {
  pose.uniqueness = from.uniqueness;
  pose.free_axis = from.free_axis;
  pose.alternatives = from.alternatives;
}

}  // namespace

Pose cpn_pose(const Surface& surface, const CpnOptions& options) {
  const Pose pca = pca_pose(surface);
  const Pose rectilinear = rectilinear_pose(surface, {.gap = options.gap, .cells = 20'000});
  Pose pose;
  pose.candidates = {pca.candidates.front(), rectilinear.candidates.front()};
  double first = 0, second = 0;
  if (options.pixels) {
    first = pixel_area(surface, pca.rotation, options.size);
    second = pixel_area(surface, rectilinear.rotation, options.size);
  } else {
    const auto [a, b] = told_apart(SummedSilhouette(surface.mesh), pca.rotation, rectilinear.rotation);
    first = middle(a), second = middle(b);
  }
  pose.candidates[0].silhouette = pose.candidates[0].score = first;
  pose.candidates[1].silhouette = pose.candidates[1].score = second;
  const bool take_pca = first < second * (options.pixels ? 1 : 1 - 1e-6);
  inherit(pose, take_pca ? pca : rectilinear);
  choose(pose, take_pca ? 0 : 1);
  pose.reason = two_figures("silhouettes %.4f of the surface by PCA, %.4f by rectilinearity", first, second);
  const double larger = std::max(first, second);  // 0 if nothing is as large as a pixel
  const double margin = larger > 0 ? std::abs(first - second) / larger : 0;
  pose.confidence = margin / (margin + 0.02);
  return pose;
}

Pose silhouette_pose(const Surface& surface, const SilhouetteOptions& options) {
  const SummedSilhouette objective(surface.mesh, options.tolerance);
  const Pose rectilinear = rectilinear_pose(surface, {.cells = 20'000, .optima = false});
  const std::vector<Rotation> starts = {pca_pose(surface).rotation, rectilinear.rotation};
  std::vector<double> values(starts.size());
  objective.values(starts, values);

  Evaluator evaluator(objective, {.evaluations = static_cast<std::uint64_t>(options.evaluations)});
  evaluator.values(starts, values);
  const auto optimizer = builtin_optimizers().make(options.optimizer);
  require_needs(*optimizer, objective);
  Random random(1);
  optimizer->run(evaluator, zone_domain(), random);

  Pose pose;
  const auto add = [&](const std::string& name, const Rotation& rotation, double value) {
    PoseCandidate candidate;
    candidate.name = name;
    candidate.rotation = rotation;
    candidate.silhouette = candidate.score = value;
    pose.candidates.push_back(std::move(candidate));
  };
  add("search", evaluator.incumbent().rotation, evaluator.incumbent().value);
  add("pca", starts[0], values[0]);
  add("rectilinear", starts[1], values[1]);
  if (values[0] > values[1]) std::swap(pose.candidates[1], pose.candidates[2]);
  choose(pose, 0);
  pose.reason = two_figures("silhouettes %.6f of the surface, %.6f where the search began", evaluator.incumbent().value,
                            std::min(values[0], values[1]));
  note_roundness(pose, surface, convex_hull(surface.mesh));
  return pose;
}

}  // namespace rectilin::pose
