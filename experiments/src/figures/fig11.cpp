// Fig. 11: meshes ranked by R.
#include <algorithm>
#include <numeric>

#include "experiments.h"
#include "rectilin/experiments/results.h"
#include "rectilin/measure/shapes.h"
#include "specimen.h"

namespace rectilin::figures {
namespace {

struct Ranking {
  int shown = 28;
  Pose pose;

  void bind(Parameters& parameters) {
    parameters.integer("shown", shown, 1, 1000, "most meshes in the picture, taken evenly from the ranking");
    pose.bind(parameters);
  }

  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<Specimen> specimens;
    if (context.meshes.empty()) {
      for (const ShapeInfo& shape : list_shapes())  // a finer sphere takes seconds
        specimens.push_back(
            specimen(shape.name, "shape:" + shape.name + (shape.name == "sphere" ? "?subdivisions=3" : "")));
    } else {
      const std::vector<std::string> names = titles(context.meshes);
      for (std::size_t i = 0; i < names.size(); ++i) specimens.push_back(specimen(names[i], context.meshes[i]));
    }
    std::vector<Measured> results = measure_all(specimens, context);
    ExperimentResult result;
    result.errors = errors(specimens, results);
    rank(specimens, results);
    if (specimens.empty()) throw MeshError(result.errors.front());

    const std::size_t count = std::min(specimens.size(), static_cast<std::size_t>(shown));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = count == 1 ? 0 : k * (specimens.size() - 1) / (count - 1);
      specimens[i].pictured = pose.of(specimens[i].origin);
      results[i].picture = thumbnail(specimens[i].make(), *specimens[i].pictured);
    }
    result.says = std::to_string(specimens.size()) + " meshes ranked by R, from " + specimens.front().label + " (" +
                  four_digits(results.front().rectilinearity) + ") to " + specimens.back().label + " (" +
                  four_digits(results.back().rectilinearity) + "); the paper shows such a ranking";
    result.data = to_json(specimens, results);
    result.sheets = {
        sheet("fig11", "From the most rectilinear to the least.", specimens, results, count <= 16 ? 4 : 7)};
    return result;
  }

  /// Those that could be measured, by decreasing R.
  static void rank(std::vector<Specimen>& specimens, std::vector<Measured>& results) {
    std::vector<std::size_t> order(results.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) { return !results[i].error.empty(); });
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return results[i].rectilinearity; });
    std::vector<Specimen> ranked;
    std::vector<Measured> values;
    for (const std::size_t i : order) {
      ranked.push_back(std::move(specimens[i]));
      values.push_back(std::move(results[i]));
    }
    specimens = std::move(ranked);
    results = std::move(values);
  }
};

}  // namespace

Experiment fig11() {
  return make_experiment<Ranking>("fig11", "Meshes ranked by R", "meshes (default: all built-in shapes)", "");
}

}  // namespace rectilin::figures
