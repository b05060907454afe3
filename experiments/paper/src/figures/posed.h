// What the figures of poses share: models, their poses by several methods, and sheets that show them.
#pragma once

#include <string>
#include <vector>

#include "figures/sample.h"
#include "rectilin/pose/pose.h"

namespace rectilin::paper::figures {

/// A model in the poses of some methods.
struct PosedModel {
  std::string title, source, error;  ///< with an error there is nothing else
  struct ByMethod {
    std::string method;
    pose::Pose pose;
    double silhouettes = 0;          ///< the three, over the surface's area
    std::string picture;             ///< the mesh in this pose, from the front, right and above
    std::vector<std::string> views;  ///< three silhouettes, if asked for
  };
  std::vector<ByMethod> poses;
};

/// Each source by each method, several at a time. The meshes' given axes serve to name the poses' axes alone, so that a
/// pose that finds them is shown upright.
std::vector<PosedModel> pose_all(const Defaults& sources, const std::vector<std::string>& methods, bool silhouettes,
                                 Up up, const ExperimentContext& context);

/// The context's meshes with titles or, if it has none, the defaults.
Defaults sources_of(const ExperimentContext& context, const Defaults& defaults);

/// A row of pictures a method; below each the method, the model and its silhouettes.
Sheet sheet_by_method(std::string name, std::string caption, const std::vector<PosedModel>& models);

/// Three silhouettes of each pose in a row, a row a pose.
Sheet sheet_of_silhouettes(std::string name, std::string caption, const std::vector<PosedModel>& models);

Json to_json(const std::vector<PosedModel>& models);
std::vector<std::string> errors(const std::vector<PosedModel>& models);

}  // namespace rectilin::paper::figures
