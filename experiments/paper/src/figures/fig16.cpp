// Figs. 16 to 18: models by principal axes and by rectilinearity, and which of the two the paper's rule adopts.
#include <algorithm>

#include "figures/experiments.h"
#include "figures/posed.h"

namespace rectilin::paper::figures {
namespace {

/// What the rule of section 6 chose, and by how much of the larger sum.
struct Choice {
  bool pca = false;
  double margin = 0;
};

Choice choice(const PosedModel& model) {
  const double a = model.poses[0].silhouettes, b = model.poses[1].silhouettes;
  return {a < b, std::abs(a - b) / std::max(a, b)};
}

enum class Shown { kAll, kRectilinear, kPca };

struct Chosen {
  Shown what = Shown::kAll;
  std::string name;
  int shown = 6;
  UpAxis up;

  void bind(Parameters& parameters) {
    parameters.integer("shown", shown, 1, 100, "models in the picture, those with the clearest choice");
    up.bind(parameters);
  }

  Defaults defaults() const {
    if (what == Shown::kAll) return {{"L", "shape:lshape"}, {"stairs", "shape:stairs"}};
    return {{"L", "shape:lshape"},
            {"stairs", "shape:stairs"},
            {"pyramid", "shape:pyramid"},
            {"cut cube", "shape:cut-cube"},
            {"ellipsoid", "shape:ellipsoid?a=3&b=2&c=1&faces=2000"},
            {"stepped pyramid", "shape:stepped-pyramid"},
            {"soup", "shape:soup?faces=40"}};
  }

  ExperimentResult run(const ExperimentContext& context) const {
    const Defaults sources = sources_of(context, defaults());
    auto models = pose_all(sources, {"pca", "rectilinear"}, false, up.of(sources.front().second), context);
    ExperimentResult result;
    result.errors = errors(models);
    result.data = to_json(models);
    std::erase_if(models, [](const PosedModel& m) { return !m.error.empty(); });
    const auto total = models.size();
    const auto by_pca = std::ranges::count_if(models, [](const PosedModel& m) { return choice(m).pca; });
    if (what != Shown::kAll)
      std::erase_if(models, [&](const PosedModel& m) { return choice(m).pca != (what == Shown::kPca); });
    std::ranges::stable_sort(models, std::greater(), [](const PosedModel& m) { return choice(m).margin; });
    if (models.size() > static_cast<std::size_t>(shown)) models.resize(static_cast<std::size_t>(shown));
    result.sheets = {sheet_by_method(name,
                                     what == Shown::kPca ? "Principal axes above, adopted; rectilinearity below."
                                                         : "Principal axes above; rectilinearity below, adopted.",
                                     models)};
    result.says = "the rule adopts PCA for " + std::to_string(by_pca) + " of " + std::to_string(total) +
                  " models and rectilinearity for the others; shown are " + std::to_string(models.size()) +
                  " with the clearest margins (paper: rectilinearity for most furniture, PCA for elongated objects)";
    return result;
  }
};

struct Cabinets : Chosen {
  Cabinets() : Chosen{Shown::kAll, "fig16", 6, {}} {}
};
struct ByRectilinearity : Chosen {
  ByRectilinearity() : Chosen{Shown::kRectilinear, "fig17", 6, {}} {}
};
struct ByPrincipalAxes : Chosen {
  ByPrincipalAxes() : Chosen{Shown::kPca, "fig18", 6, {}} {}
};

}  // namespace

Experiment fig16() {
  return make_experiment<Cabinets>("fig16", "Cabinets by principal axes and by rectilinearity",
                                   "cabinets (default: two built-in shapes)", "");
}

Experiment fig17() {
  return make_experiment<ByRectilinearity>("fig17", "Models for which the paper's rule adopts the rectilinear pose",
                                           "models (default: built-in shapes)", "");
}

Experiment fig18() {
  return make_experiment<ByPrincipalAxes>("fig18", "Models for which the paper's rule adopts principal axes",
                                          "models (default: built-in shapes)", "");
}

}  // namespace rectilin::paper::figures
