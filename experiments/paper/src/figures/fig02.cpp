// Fig. 2: a cabinet by principal axes and by rectilinearity.
#include "figures/experiments.h"
#include "figures/posed.h"

namespace rectilin::paper::figures {
namespace {

struct TwoWays {
  UpAxis up;

  void bind(Parameters& parameters) { up.bind(parameters); }

  ExperimentResult run(const ExperimentContext& context) const {
    const Defaults sources = sources_of(context, {{"L-shaped cabinet", "shape:lshape"}});
    const auto models = pose_all(sources, {"pca", "rectilinear"}, false, up.of(sources.front().second), context);
    ExperimentResult result;
    result.errors = errors(models);
    result.data = to_json(models);
    result.sheets = {sheet_by_method("fig2", "Principal axes above, rectilinearity below.", models)};
    for (const PosedModel& model : models) {
      if (!model.error.empty()) continue;
      const double turned = frame_angle(model.poses[0].pose.rotation, model.poses[1].pose.rotation) * 57.29577951308232;
      result.says = model.title + ": PCA's axes are " + number(turned) +
                    " degrees from the rectilinear pose (paper: PCA's contradict intuition)";
      break;
    }
    return result;
  }
};

}  // namespace

Experiment fig2() {
  return make_experiment<TwoWays>("fig2", "A cabinet by principal axes and by rectilinearity",
                                  "cabinets (default: a built-in L)", "");
}

}  // namespace rectilin::paper::figures
