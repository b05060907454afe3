// Fig. 13: faces deleted at random. The paper: "Even if 90% faces of the mesh are discarded, the
// rectilinearity value varies by less than 0.005."
#include <algorithm>
#include <array>
#include <cmath>

#include "figures/experiments.h"
#include "figures/sample.h"
#include "rectilin/laboratory/statistics.h"
#include "rectilin/mesh/edits.h"

namespace rectilin::paper::figures {
namespace {

constexpr std::array kDeleted = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99};
constexpr double kClaimedAt = 0.9, kClaimed = 0.005;
constexpr std::array kPicturedParts = {0.0, 0.5, 0.9, 0.99};

/// Of one mesh at one part of faces deleted, over all runs.
struct Spread {
  double least = NAN, median = NAN, largest = NAN;
  double change = NAN;  ///< the largest distance from the whole mesh's R
};

struct Deletion {
  int runs = 20;
  int faces = 100'000;
  UpAxis pose;

  void bind(Parameters& parameters) {
    parameters.integer("runs", runs, 1, 10'000, "random choices of the faces to be deleted");
    parameters.integer("faces", faces, 1000, 10'000'000, "of the built-in blob");
    pose.bind(parameters);
  }

  ExperimentResult run(const ExperimentContext& context) const {
    ExperimentResult result;
    const std::vector<Model> models = load_models(context, made_and_scanned(faces), result.errors);
    const std::vector<Sample> samples = plan(models, context.seed);
    const std::vector<Measured> results = measure_all(samples, context);
    const std::vector<std::vector<Spread>> spreads = summarise(models.size(), results);

    result.says = claim(models, spreads);
    result.data = to_json(samples, results);
    result.plots = {curves(models, spreads), changes(models, spreads)};
    result.sheets = {sheet("fig13-meshes", "The meshes without some of their faces (first run).", samples, results)};
    for (std::string& error : errors(results)) result.errors.push_back(std::move(error));
    return result;
  }

 private:
  /// By mesh, part deleted, and run.
  std::vector<Sample> plan(const std::vector<Model>& models, std::uint64_t seed) const {
    std::vector<Sample> samples;
    for (const Model& model : models)
      for (const double part : kDeleted)
        for (int run = 0; run < runs; ++run) {
          const std::string what = ", " + number(100 * part) + " % deleted";
          const Random random = Random(seed).fork(static_cast<std::uint64_t>(run));
          samples.push_back({model.title + what, model.source + what + ", run " + std::to_string(run + 1),
                             [mesh = model.mesh, part, random] { return without_faces(*mesh, part, random); }});
          if (run == 0 && std::ranges::count(kPicturedParts, part) > 0) samples.back().pictured = pose.of(model.source);
        }
    return samples;
  }

  std::vector<std::vector<Spread>> summarise(std::size_t models, const std::vector<Measured>& results) const {
    std::vector<std::vector<Spread>> spreads(models);
    auto next = results.begin();
    for (auto& of_model : spreads) {
      const double whole = next->result.value;
      for (std::size_t i = 0; i < kDeleted.size(); ++i) {
        std::vector<double> values;
        for (int run = 0; run < runs; ++run, ++next)
          if (next->error.empty()) values.push_back(next->result.value);
        Spread& spread = of_model.emplace_back();
        if (values.empty()) continue;
        const auto [least, largest] = std::ranges::minmax(values);
        spread = {least, laboratory::median(values), largest, std::max(largest - whole, whole - least)};
      }
    }
    return spreads;
  }

  std::string claim(const std::vector<Model>& models, const std::vector<std::vector<Spread>>& spreads) const {
    const auto at = std::ranges::find(kDeleted, kClaimedAt) - kDeleted.begin();
    std::string text = "with 90 % of the faces deleted R changes by at most ";
    for (std::size_t m = 0; m < models.size(); ++m)
      text += (m > 0 ? ", " : "") + four_digits(spreads[m][at].change) + " (" + models[m].title + ")";
    return text + " in " + std::to_string(runs) + " runs (paper: less than 0.005)";
  }

  static report::Csv table(const std::vector<Model>& models, const std::vector<std::vector<Spread>>& spreads) {
    std::vector<std::string> columns = {"deleted", "claimed"};
    for (const Model& model : models)
      for (const char* what : {"median", "least", "largest", "change"}) columns.push_back(model.title + " " + what);
    report::Csv csv(columns);
    for (std::size_t i = 0; i < kDeleted.size(); ++i) {
      std::vector<report::Csv::Cell> row = {100 * kDeleted[i], kClaimed};
      for (const auto& of_model : spreads)
        for (const double x : {of_model[i].median, of_model[i].least, of_model[i].largest, of_model[i].change})
          row.emplace_back(x);
      csv.row(row);
    }
    return csv;
  }

  report::NamedPlot curves(const std::vector<Model>& models, const std::vector<std::vector<Spread>>& spreads) const {
    report::Panel panel{
        .title = "", .x = {.label = "faces deleted, %"}, .y = {.label = "R"}, .bands = {}, .curves = {}};
    for (int m = 0; m < static_cast<int>(models.size()); ++m) {
      panel.bands.push_back({.low = 4 + 4 * m, .high = 5 + 4 * m, .style = {.colour = m}});
      panel.curves.push_back({.y = 3 + 4 * m, .label = models[m].title, .style = {.colour = m}, .points = true});
    }
    return {"fig13", "Median and range of R over " + std::to_string(runs) + " random choices of the deleted faces.",
            report::Plot("R of what random deletion leaves", table(models, spreads), {panel})};
  }

  report::NamedPlot changes(const std::vector<Model>& models, const std::vector<std::vector<Spread>>& spreads) const {
    report::Panel panel{.title = "",
                        .x = {.label = "faces deleted, %"},
                        .y = {.label = "largest change of R", .logarithmic = true},
                        .bands = {},
                        .curves = {{.y = 2, .label = "0.005", .style = {.colour = 6, .dash = 1}}}};
    for (int m = 0; m < static_cast<int>(models.size()); ++m)
      panel.curves.push_back({.y = 6 + 4 * m, .label = models[m].title, .style = {.colour = m}, .points = true});
    return {"fig13-change", "Largest change of R over the runs. The paper reports less than 0.005 at 90 %.",
            report::Plot("How far R moves", table(models, spreads), {panel})};
  }
};

}  // namespace

Experiment fig13() {
  return make_experiment<Deletion>("fig13", "Random deletion of faces", "meshes (default: a torus and a rough blob)",
                                   "runs=2&faces=2000");
}

}  // namespace rectilin::paper::figures
