// Fig. 14: simplified meshes, down to 1 % of the faces.
#include <algorithm>
#include <array>
#include <cmath>

#include "figures/experiments.h"
#include "figures/sample.h"
#include "rectilin/mesh/edits.h"

namespace rectilin::paper::figures {
namespace {

constexpr std::array kKept = {1.0, 0.5, 0.25, 0.1, 0.05, 0.025, 0.01};
constexpr std::array kPicturedTargets = {1.0, 0.1, 0.01};

struct Simplification {
  int faces = 100'000;
  UpAxis pose;

  void bind(Parameters& parameters) {
    parameters.integer("faces", faces, 1000, 10'000'000, "of the built-in blob");
    pose.bind(parameters);
  }

  ExperimentResult run(const ExperimentContext& context) const {
    ExperimentResult result;
    const std::vector<Model> models = load_models(context, made_and_scanned(faces), result.errors);
    std::vector<Sample> samples;
    for (const Model& model : models)
      for (const double part : kKept) {
        const std::string what = ", " + number(100 * part) + " %";
        samples.push_back({model.title + what, model.source + what + " of the faces", [mesh = model.mesh, part] {
                             const double kept = part * static_cast<double>(mesh->triangles.size());
                             return simplified(*mesh, static_cast<std::size_t>(kept));
                           }});
        if (std::ranges::count(kPicturedTargets, part) > 0) samples.back().pictured = pose.of(model.source);
      }
    const std::vector<Measured> results = measure_all(samples, context);
    for (std::size_t i = 0; i < samples.size(); ++i)  // what was asked for is not always reached
      samples[i].label = models[i / kKept.size()].title + ", " + std::to_string(results[i].result.faces) + " faces";

    result.says = "R changes by at most " + change(models, results, 0.1) + " at 10 % of the faces and " +
                  change(models, results, 0.01) + " at 1 % (paper: little effect)";
    result.data = to_json(samples, results);
    result.plots = {curves(models, results)};
    result.sheets = {sheet("fig14-meshes", "The meshes, simplified.", samples, results, 3)};
    for (std::string& error : errors(results)) result.errors.push_back(std::move(error));
    return result;
  }

 private:
  /// Largest over the meshes.
  static std::string change(const std::vector<Model>& models, const std::vector<Measured>& results, double part) {
    const auto at = std::ranges::find(kKept, part) - kKept.begin();
    double largest = 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
      const Measured* of_model = &results[m * kKept.size()];
      if (of_model[at].error.empty())
        largest = std::max(largest, std::abs(of_model[at].result.value - of_model[0].result.value));
    }
    return four_digits(largest);
  }

  static report::NamedPlot curves(const std::vector<Model>& models, const std::vector<Measured>& results) {
    std::vector<std::string> columns = {"asked"};
    for (const Model& model : models)
      for (const char* what : {"faces", "left", "R"}) columns.push_back(model.title + " " + what);
    report::Csv csv(columns);
    for (std::size_t i = 0; i < kKept.size(); ++i) {
      std::vector<report::Csv::Cell> row = {100 * kKept[i]};
      for (std::size_t m = 0; m < models.size(); ++m) {
        const Measured& r = results[m * kKept.size() + i];
        const bool known = r.error.empty();
        const auto all = static_cast<double>(models[m].mesh->triangles.size());
        row.insert(row.end(), {r.result.faces, known ? 100 * static_cast<double>(r.result.faces) / all : NAN,
                               known ? r.result.value : NAN});
      }
      csv.row(row);
    }
    report::Panel panel{.title = "",
                        .x = {.label = "faces left, %", .logarithmic = true, .lower = 0.8, .upper = 100},
                        .y = {.label = "R"},
                        .bands = {},
                        .curves = {}};
    for (int m = 0; m < static_cast<int>(models.size()); ++m)
      panel.curves.push_back(
          {.x = 3 + 3 * m, .y = 4 + 3 * m, .label = models[m].title, .style = {.colour = m}, .points = true});
    return {"fig14", "R of simplified meshes.", report::Plot("R of simplified meshes", csv, {panel})};
  }
};

}  // namespace

Experiment fig14() {
  return make_experiment<Simplification>("fig14", "Quadric simplification, down to 1 % of the faces",
                                         "meshes (default: a torus and a rough blob)", "faces=2000");
}

}  // namespace rectilin::paper::figures
