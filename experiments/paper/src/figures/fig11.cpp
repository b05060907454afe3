// Fig. 11: meshes ranked by R.
#include <algorithm>
#include <numeric>

#include "figures/experiments.h"
#include "figures/sample.h"
#include "rectilin/laboratory/results.h"
#include "rectilin/mesh/shapes.h"

namespace rectilin::paper::figures {
namespace {

struct Ranking {
  int shown = 28;
  UpAxis pose;

  void bind(Parameters& parameters) {
    parameters.integer("shown", shown, 1, 1000, "most meshes in the picture, taken evenly from the ranking");
    pose.bind(parameters);
  }

  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<Sample> samples;
    if (context.meshes.empty()) {
      for (const auto& shape : shape_table().entries())  // a finer sphere takes seconds
        samples.push_back(
            sample(shape.name, "shape:" + shape.name + (shape.name == "sphere" ? "?subdivisions=3" : "")));
    } else {
      const std::vector<std::string> names = laboratory::titles(context.meshes);
      for (std::size_t i = 0; i < names.size(); ++i) samples.push_back(sample(names[i], context.meshes[i]));
    }
    std::vector<Measured> results = measure_all(samples, context);
    ExperimentResult result;
    result.errors = errors(results);
    rank(samples, results);
    if (samples.empty()) throw MeshError(result.errors.front());

    const std::size_t count = std::min(samples.size(), static_cast<std::size_t>(shown));
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = count == 1 ? 0 : k * (samples.size() - 1) / (count - 1);
      samples[i].pictured = pose.of(samples[i].origin);
      results[i].picture = thumbnail(samples[i].make(), *samples[i].pictured);
    }
    result.says = std::to_string(samples.size()) + " meshes ranked by R, from " + samples.front().label + " (" +
                  four_digits(results.front().result.value) + ") to " + samples.back().label + " (" +
                  four_digits(results.back().result.value) + "); the paper shows such a ranking";
    result.data = to_json(samples, results);
    result.sheets = {sheet("fig11", "From the most rectilinear to the least.", samples, results, count <= 16 ? 4 : 7)};
    return result;
  }

  /// Those that could be measured, by decreasing R.
  static void rank(std::vector<Sample>& samples, std::vector<Measured>& results) {
    std::vector<std::size_t> order(results.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) { return !results[i].error.empty(); });
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return results[i].result.value; });
    std::vector<Sample> ranked;
    std::vector<Measured> values;
    for (const std::size_t i : order) {
      ranked.push_back(std::move(samples[i]));
      values.push_back(std::move(results[i]));
    }
    samples = std::move(ranked);
    results = std::move(values);
  }
};

}  // namespace

Experiment fig11() {
  return make_experiment<Ranking>("fig11", "Meshes ranked by R", "meshes (default: all built-in shapes)", "");
}

}  // namespace rectilin::paper::figures
