#include "rectilin/retrieval/poses.h"

#include "rectilin/base/factory.h"
#include "rectilin/pose/axes.h"
#include "rectilin/pose/pose.h"
#include "rectilin/retrieval/model.h"

namespace rectilin::retrieval {

const std::vector<std::pair<std::string, std::string>>& pose_names() {
  static const std::vector<std::pair<std::string, std::string>> names{
      {"none", "the file's own axes"},
      {"rectilinear", "the rotation of the largest rectilinearity"},
      {"pca", "the surface's principal axes, in any order"},
      {"pca-ordered", "the same, the largest second moment along x and the least along z"},
      {"pca-definite", "the same, x and y pointing to the side with more of the surface"},
      {"cpn", "the paper's choice between pca and rectilinear"},
      {"composite", "the best of all methods by projected area and mirror symmetry"},
  };
  return names;
}

void bind_pose(Parameters& parameters, std::string& pose) {
  std::vector<std::pair<std::string, std::string>> words;
  std::string help = "frame the model is brought into: ";
  for (const auto& [name, meaning] : pose_names()) {
    words.emplace_back(name, name);
    help += (words.size() > 1 ? "; " : "") + name + ", " + meaning;
  }
  parameters.choice("pose", pose, std::move(words), std::move(help));
}

const Frame& Model::frame(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Frame>& frame = frames_[name];
  if (frame) return *frame;
  Frame found = surface_;
  const auto by = [&](const char* method) { return pose::pose_methods().make(method)(mesh_).rotation; };
  if (name == "rectilinear") {
    found.rotation = rectilinear().rotation;
  } else if (name == "pca" || name == "cpn" || name == "composite") {
    found.rotation = by(name.c_str());
  } else if (name == "pca-ordered") {
    found.rotation = pose::resolve_axes(mesh_, by("pca"), pose::AxisRule::kOrdered).rotation;
  } else if (name == "pca-definite") {
    found.rotation = pose::resolve_axes(mesh_, by("pca"), pose::AxisRule::kDefinite).rotation;
  } else if (name != "none") {
    std::vector<std::string> known;
    for (const auto& [known_name, meaning] : pose_names()) known.push_back(known_name);
    throw_unknown_name("pose", name, known);
  }
  frame = std::make_unique<Frame>(found);
  return *frame;
}

const Mesh& Model::posed(const std::string& pose) const {
  const Frame& into = frame(pose);
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Mesh>& mesh = posed_[pose];
  if (!mesh) mesh = std::make_unique<Mesh>(transformed(mesh_, into));
  return *mesh;
}

}  // namespace rectilin::retrieval
