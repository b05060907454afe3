// A mesh's pose as `rectilin pose` finds it, for printing and for stores.
#pragma once

#include <array>
#include <string>

#include "rectilin/corpus/worker.h"
#include "rectilin/mesh/mesh_io.h"
#include "rectilin/pose/axes.h"
#include "rectilin/pose/pose.h"

namespace rectilin::app {

/// What a pose depends on, besides the mesh.
struct PoseSettings {
  std::string method = "composite";
  std::string axes = "free";
};

struct Posed {
  pose::Pose pose;
  bool resolved = true;
  double area = 0;
  MeshReport report;
  std::string file;                     ///< where the posed mesh was written
  std::array<std::string, 3> pictures;  ///< set if there is to be a contact sheet
};

class Poser {
 public:
  /// Throws ParameterError for a method that cannot be made.
  explicit Poser(const PoseSettings& settings);
  Posed operator()(const LoadedMesh& loaded) const;

 private:
  pose::PoseMethod method_;
  pose::AxisRule rule_;
};

inline constexpr const char* kPoseTask = "pose";

/// The task of a store, and what workers do for it: rows as `rectilin pose --json` prints them.
corpus::Task pose_task(const PoseSettings& settings);
corpus::Work pose_work(const Json& settings);

}  // namespace rectilin::app
