// Fig. 19: the criterion. The right pose has the smaller silhouettes.
#include <cstdio>

#include "figures/experiments.h"
#include "figures/posed.h"

namespace rectilin::paper::figures {
namespace {

struct Criterion {
  UpAxis up;

  void bind(Parameters& parameters) { up.bind(parameters); }

  ExperimentResult run(const ExperimentContext& context) const {
    const Defaults sources = sources_of(context, {{"L-shaped cabinet", "shape:lshape"}});
    const auto models = pose_all(sources, {"rectilinear", "pca"}, true, up.of(sources.front().second), context);
    ExperimentResult result;
    result.errors = errors(models);
    result.data = to_json(models);
    result.sheets = {
        sheet_of_silhouettes("fig19", "The three silhouettes of each pose, and their summed area.", models)};
    for (const PosedModel& model : models) {
      if (!model.error.empty()) continue;
      char text[200];
      std::snprintf(text, sizeof text,
                    ": the silhouettes are %.4f of the surface in the rectilinear pose, %.4f by PCA (paper: the right "
                    "pose has the smaller sum)",
                    model.poses[0].silhouettes, model.poses[1].silhouettes);
      result.says = model.title + text;
      break;
    }
    return result;
  }
};

}  // namespace

Experiment fig19() {
  return make_experiment<Criterion>("fig19", "The paper's criterion: summed silhouettes",
                                    "a cabinet (default: a built-in L)", "");
}

}  // namespace rectilin::paper::figures
