#include "rectilin/pose/json.h"

#include <cmath>

#include "rectilin/optim/run_record.h"

namespace rectilin::pose {
namespace {

Json number(std::optional<double> x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }

Json to_json(const PoseCandidate& candidate, double area) {
  const auto times = [](std::optional<double> share, double unit) {
    return share ? number(*share * unit) : Json(nullptr);
  };
  return {{"name", candidate.name},
          {"rotation", rectilin::to_json(candidate.rotation)},
          {"projected_area", times(candidate.projected, area)},
          {"silhouette_area", times(candidate.silhouette, area)},
          {"volume", times(candidate.volume, std::pow(area, 1.5))},
          {"mirror_defects", candidate.mirror_defects},
          {"flat_share", number(candidate.flat_share)},
          {"score", number(candidate.score)}};
}

}  // namespace

Json to_json(const Pose& pose, double area) {
  Json alternatives = Json::array(), candidates = Json::array();
  for (const Rotation& rotation : pose.alternatives) alternatives.push_back(rectilin::to_json(rotation));
  for (const PoseCandidate& candidate : pose.candidates) candidates.push_back(to_json(candidate, area));
  return {{"method", pose.method},
          {"chosen", pose.chosen},
          {"reason", pose.reason},
          {"rotation", rectilin::to_json(pose.rotation)},
          {"centre", {pose.centre.x(), pose.centre.y(), pose.centre.z()}},
          {"scale", pose.scale},
          {"unique", pose.uniqueness == Uniqueness::kUnique},
          {"uniqueness", to_string(pose.uniqueness)},
          {"free_axis", pose.free_axis < 0 ? Json(nullptr) : Json(std::string(1, "xyz"[pose.free_axis]))},
          {"alternatives", alternatives},
          {"confidence", pose.confidence},
          {"candidates", candidates}};
}

}  // namespace rectilin::pose
