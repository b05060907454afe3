// What the experiments about poses share: models, their poses by several methods, and sheets that show them.
#pragma once

#include <string>
#include <vector>

#include "figures/sample.h"
#include "rectilin/pose/pose.h"

namespace rectilin::paper::figures {

/// A model and its poses by several methods.
struct PosedModel {
  std::string title, source, error;  ///< if there is an error, nothing else is set
  struct ByMethod {
    std::string method;
    pose::Pose pose;
    double silhouettes = 0;          ///< area of the three silhouettes, relative to the surface
    std::string picture;             ///< the mesh in this pose, from the front, right and above
    std::vector<std::string> views;  ///< three silhouettes, if asked for
  };
  std::vector<ByMethod> poses;
};

/// Finds the pose of each source by each method, several at a time. The meshes' given axes are used only to name the
/// axes of a pose, so that a pose that finds them is shown upright.
std::vector<PosedModel> pose_all(const Defaults& sources, const std::vector<std::string>& methods, bool silhouettes,
                                 Up up, const ExperimentContext& context);

/// The context's meshes with their titles or, if there are none, the defaults.
Defaults sources_of(const ExperimentContext& context, const Defaults& defaults);

/// A sheet with a row of pictures for each method; below each picture the method, the model and its silhouettes.
Sheet sheet_by_method(std::string name, std::string caption, const std::vector<PosedModel>& models);

/// A sheet with a row for each pose that shows its three silhouettes.
Sheet sheet_of_silhouettes(std::string name, std::string caption, const std::vector<PosedModel>& models);

Json to_json(const std::vector<PosedModel>& models);
std::vector<std::string> errors(const std::vector<PosedModel>& models);

}  // namespace rectilin::paper::figures
