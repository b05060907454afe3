// A few objects as they come, in any pose, and beside each the pose that R names: what the README shows first.
#include <cstdio>

#include "figures/chair.h"
#include "figures/experiments.h"
#include "figures/sample.h"
#include "rectilin/mesh/source.h"

namespace rectilin::paper::figures {
namespace {

Mesh turned(Mesh mesh, const Eigen::Matrix3d& rotation) {
  for (Vector3& p : mesh.vertices) p = rotation * p;
  return mesh;
}

/// The frame leaves open which axis is up: of the 24 rotations with the same planes, the one that brings the object
/// back nearest to how it stood before it was turned by `tilt`.
Eigen::Matrix3d upright(const Rotation& pose, const Rotation& tilt) {
  const Eigen::Matrix3d undone = pose.matrix() * tilt.matrix();
  const Rotation* best = nullptr;
  double nearest = -4;
  for (const Rotation& symmetry : frame_symmetries()) {
    const double trace = (symmetry.matrix() * undone).trace();
    if (trace > nearest) nearest = trace, best = &symmetry;
  }
  return best->matrix() * pose.matrix();
}

std::string interval(const Measured& measured) {
  char text[64];
  std::snprintf(text, sizeof text, "in its pose, R known to %.0e", measured.upper() - measured.lower());
  return text;
}

struct Gallery {
  void bind(Parameters&) {}

  ExperimentResult run(const ExperimentContext& context) const {
    Random random(context.seed);
    const Rotation tilt = random_rotation(random);
    std::vector<Sample> samples;
    const auto add = [&](const std::string& label, const std::string& origin, const std::function<Mesh()>& make) {
      samples.push_back({label, origin, [make, tilt] { return turned(make(), tilt.matrix()); }, Up::kZ});
    };
    add("stairs", "shape:stairs", [] { return load_mesh("shape:stairs").mesh; });
    add("chair", "a built-in chair", [] { return chair({.slats = 4}); });
    add("rounded cube", "shape:filleted-cube", [] { return load_mesh("shape:filleted-cube").mesh; });
    const std::vector<Measured> results = measure_all(samples, context);

    std::vector<report::SheetCell> cells;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!results[i].error.empty()) continue;
      const Mesh mesh = samples[i].make();
      const Eigen::Matrix3d pose = upright(results[i].result.rotation, tilt);
      cells.push_back({results[i].picture, samples[i].label, "as it comes"});
      cells.push_back({render::thumbnail(turned(mesh, pose), Up::kZ), interval(results[i]),
                       "R = " + four_digits(results[i].value())});
    }
    ExperimentResult result;
    result.says =
        std::to_string(cells.size() / 2) + " objects in the pose that R names (the paper's Fig. 2 shows such)";
    result.data = to_json(samples, results);
    Sheet shown = sheet("gallery", "Objects as they come and in their pose.", samples, results);
    const ContactSheet drawn = report::contact_sheet(cells, 6);
    shown.svg = drawn.svg;
    shown.width = drawn.width;
    result.sheets = {std::move(shown)};
    result.errors = errors(results);
    return result;
  }
};

}  // namespace

Experiment gallery() { return make_experiment<Gallery>("gallery", "Objects in any pose and in their own", "", ""); }

}  // namespace rectilin::paper::figures
