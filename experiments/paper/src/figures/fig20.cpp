// Fig. 20: where the paper's rule fails: it takes the wrong one of two poses, or both are wrong.
#include <algorithm>
#include <numbers>

#include "figures/experiments.h"
#include "figures/posed.h"

namespace rectilin::paper::figures {
namespace {

constexpr double kRightAngle = 10 * std::numbers::pi / 180;

/// The methods, in the order of the rows.
const std::vector<std::string> kMethods = {"pca", "rectilinear", "cpn", "composite"};

struct Failures {
  int shown = 7;
  UpAxis up;

  void bind(Parameters& parameters) {
    parameters.integer("shown", shown, 1, 100, "models in the picture");
    up.bind(parameters);
  }

  ExperimentResult run(const ExperimentContext& context) const {
    const Defaults sources = sources_of(context, {{"pyramid", "shape:pyramid"},
                                                  {"cut cube", "shape:cut-cube"},
                                                  {"stepped pyramid", "shape:stepped-pyramid"},
                                                  {"prism", "shape:prism"},
                                                  {"filleted cube", "shape:filleted-cube"},
                                                  {"torus", "shape:torus?slices=40&stacks=20"}});
    auto models = pose_all(sources, kMethods, false, up.of(sources.front().second), context);
    ExperimentResult result;
    result.errors = errors(models);
    result.data = to_json(models);
    std::erase_if(models, [](const PosedModel& m) { return !m.error.empty(); });
    const std::size_t total = models.size();
    const auto right = [](const PosedModel& model, std::size_t method) {
      return frame_angle(model.poses[method].pose.rotation, Rotation()) <= kRightAngle;
    };
    const auto ours = std::ranges::count_if(models, [&](const PosedModel& m) { return right(m, 3); });
    std::erase_if(models, [&](const PosedModel& m) { return right(m, 2); });
    const auto wrong_choice =
        std::ranges::count_if(models, [&](const PosedModel& m) { return right(m, 0) || right(m, 1); });
    result.says = "of " + std::to_string(total) + " models the paper's rule fails " + std::to_string(models.size()) +
                  ": " + std::to_string(wrong_choice) + " by its choice, " +
                  std::to_string(models.size() - static_cast<std::size_t>(wrong_choice)) +
                  " because both poses are wrong; composite fails " +
                  std::to_string(total - static_cast<std::size_t>(ours)) +
                  " (paper: 1.8 % of the Princeton models, 80 % of them by the choice)";
    std::ranges::stable_sort(models, std::greater(), [&](const PosedModel& m) { return right(m, 0) || right(m, 1); });
    // Some of both kinds.
    if (models.size() > static_cast<std::size_t>(shown)) {
      std::vector<PosedModel> some;
      for (int i = 0; i < shown; ++i)
        some.push_back(models[static_cast<std::size_t>(i) * models.size() / static_cast<std::size_t>(shown)]);
      models = std::move(some);
    }
    result.sheets = {sheet_by_method(
        "fig20",
        "Rows: PCA, rectilinear, the paper's choice, composite. A pose is right within 10 degrees of the given axes.",
        models)};
    return result;
  }
};

}  // namespace

Experiment fig20() {
  return make_experiment<Failures>("fig20", "Models on which the paper's rule fails",
                                   "models whose axes are right (default: built-in shapes)", "");
}

}  // namespace rectilin::paper::figures
