#include "poser.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rectilin/measure/area_vectors.h"
#include "rectilin/pose/json.h"
#include "rectilin/pose/summed_silhouette.h"

namespace rectilin::app {
namespace {

using pose::AxisRule;

constexpr double kSilhouettes = 1e-4;  // relative width of the areas in the table

const std::vector<std::pair<std::string, AxisRule>> kRules = {{"free", AxisRule::kFree},
                                                              {"ordered", AxisRule::kOrdered},
                                                              {"pca4", AxisRule::kOrdered},
                                                              {"definite", AxisRule::kDefinite}};

AxisRule rule_of(const std::string& name) {
  const auto rule = std::ranges::find(kRules, name, &std::pair<std::string, AxisRule>::first);
  if (rule == kRules.end()) throw ParameterError("no order of axes '" + name + "'");
  return rule->second;
}

/// Renames the frame's axes; the free one keeps its place in space.
void follow(pose::Pose& pose, const Rotation& rotation) {
  if (pose.free_axis >= 0) {
    const Vector3 free = pose.rotation.axis(pose.free_axis);
    int best = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(rotation.axis(k).dot(free)) > std::abs(rotation.axis(best).dot(free))) best = k;
    pose.free_axis = best;
  }
  pose.rotation = rotation;
}

}  // namespace

Poser::Poser(const PoseSettings& settings)
    : method_(pose::pose_methods().make(settings.method)), rule_(rule_of(settings.axes)) {}

Posed Poser::operator()(const LoadedMesh& loaded) const {
  const Mesh& mesh = loaded.mesh;
  Posed posed;
  posed.report = loaded.report;
  posed.pose = method_(mesh);
  const pose::Axes axes = pose::resolve_axes(mesh, posed.pose.rotation, rule_);
  follow(posed.pose, axes.rotation);
  posed.resolved = axes.resolved;
  posed.area = area_vectors(mesh).area();
  const pose::SummedSilhouette silhouette(mesh, kSilhouettes);
  for (pose::PoseCandidate& candidate : posed.pose.candidates)
    if (!candidate.silhouette) {
      double value = 0;
      silhouette.values({&candidate.rotation, 1}, {&value, 1});
      candidate.silhouette = value;
    }
  return posed;
}

corpus::Task pose_task(const PoseSettings& settings) {
  return {kPoseTask, {{"method", settings.method}, {"axes", settings.axes}}};
}

corpus::Work pose_work(const Json& settings) {
  const Poser poser({settings.at("method").get<std::string>(), settings.at("axes").get<std::string>()});
  return [poser](const NamedSource&, const LoadedMesh& loaded) {
    const Posed posed = poser(loaded);
    Json row = {{"faces", loaded.mesh.triangles.size()}, {"area", posed.area}};
    row.update(pose::to_json(posed.pose, posed.area));
    return corpus::WorkResult{row};
  };
}

}  // namespace rectilin::app
