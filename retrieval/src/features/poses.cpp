#include "rectilin/retrieval/poses.h"

#include "rectilin/base/factory.h"
#include "rectilin/retrieval/model.h"

namespace rectilin::retrieval {

const std::vector<std::pair<std::string, std::string>>& pose_names() {
  static const std::vector<std::pair<std::string, std::string>> names{
      {"none", "the file's own axes"},
      {"rectilinear", "the rotation of the largest rectilinearity"},
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

const Frame& Model::frame(const std::string& pose) const {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Frame>& frame = frames_[pose];
  if (frame) return *frame;
  Frame found = surface_;
  if (pose == "rectilinear") {
    found.rotation = rectilinear().rotation;
  } else if (pose != "none") {
    std::vector<std::string> known;
    for (const auto& [name, meaning] : pose_names()) known.push_back(name);
    throw_unknown_name("pose", pose, known);
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
