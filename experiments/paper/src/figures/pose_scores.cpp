#include "figures/pose_scores.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace rectilin::paper::figures {
namespace {

constexpr double kZ = 1.959963984540054;  // 97.5 % of a normal distribution lie below

double wilson(const Share& share, double sign) {
  if (share.of == 0) return sign < 0 ? 0 : 1;
  const double n = static_cast<double>(share.of), p = share.value(), zz = kZ * kZ;
  const double spread = kZ * std::sqrt(p * (1 - p) / n + zz / (4 * n * n));
  return std::clamp((p + zz / (2 * n) + sign * spread) / (1 + zz / n), 0.0, 1.0);
}

double angle_of(const ScoredPose& pose, Rule rule) { return rule == Rule::kPlain ? pose.angle : pose.revolved_angle; }

}  // namespace

double Share::lower() const { return wilson(*this, -1); }
double Share::upper() const { return wilson(*this, 1); }

Share share_within(const std::vector<ScoredPose>& poses, double degrees, Rule rule) {
  Share share{0, poses.size()};
  for (const ScoredPose& pose : poses) share.hits += angle_of(pose, rule) <= degrees;
  return share;
}

Share surer_half(std::vector<ScoredPose> poses, double degrees, Rule rule) {
  std::ranges::stable_sort(poses, std::greater(), &ScoredPose::confidence);
  poses.resize((poses.size() + 1) / 2);
  return share_within(poses, degrees, rule);
}

Share consistency(const std::vector<ScoredPose>& poses, double degrees) {
  std::vector<std::size_t> rank(poses.size());
  std::map<std::size_t, std::size_t> seen;
  for (std::size_t i = 0; i < poses.size(); ++i) rank[i] = seen[poses[i].model]++;
  Share share;
  for (std::size_t i = 0; i < poses.size(); ++i)
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      if (poses[i].group != poses[j].group || poses[i].model == poses[j].model || rank[i] != rank[j]) continue;
      ++share.of;
      // Frames count as one if their axes are: frame_angle() lets the rows of the first be permuted.
      share.hits += frame_angle(poses[i].frame, poses[j].frame) * (180 / std::numbers::pi) <= degrees;
    }
  return share;
}

std::map<std::string, std::string> classes_by_model(const retrieval::Classification& classification) {
  std::map<std::string, std::string> classes;
  for (std::size_t i = 0; i < classification.models.size(); ++i)
    classes[classification.models[i]] = classification.classes[classification.class_of[i]].name;
  return classes;
}

std::optional<std::string> class_of(const std::string& source, const std::map<std::string, std::string>& classes) {
  const std::string stem = std::filesystem::path(source).stem().string();
  if (const auto found = classes.find(stem); found != classes.end()) return found->second;
  if (stem.starts_with('m'))
    if (const auto found = classes.find(stem.substr(1)); found != classes.end()) return found->second;
  return std::nullopt;
}

}  // namespace rectilin::paper::figures
