// How the certified interval closes: the gap between the best R found and the bound no rotation exceeds, against the
// boxes looked at and against time, on meshes of different kinds.
#include <algorithm>
#include <cmath>

#include "figures/experiments.h"
#include "figures/sample.h"

namespace rectilin::paper::figures {
namespace {

/// One trajectory; thinned, as thousands of steps look the same as a hundred.
struct Trajectory {
  std::string label;
  std::vector<double> cells, seconds, gap;
  CertifyResult result;
};

constexpr double kThinnest = 0.98;  // a step is kept if it lowers the gap by this factor

Trajectory follow(const Sample& sample, const ExperimentContext& context) {
  const Rectilinearity measured =
      measure(sample.make(), {.certify = {.gap = context.gap}, .run = {.stop = context.stop}});
  if (context.stop.stop_requested()) throw Stopped();
  Trajectory path{sample.label, {}, {}, {}, *measured.proof};
  double last = std::numeric_limits<double>::infinity();
  for (const CertifyResult::Step& step : path.result.trajectory) {
    const double width = rectilinearity(step.lower) - rectilinearity(step.value);
    const bool end = &step == &path.result.trajectory.back();
    if (!std::isfinite(step.value) || !(width < kThinnest * last || end)) continue;
    last = width;
    path.cells.push_back(static_cast<double>(step.cells));
    path.seconds.push_back(step.seconds);
    path.gap.push_back(width);
  }
  return path;
}

/// Three columns a mesh: cells, seconds, gap.
report::Csv table(const std::vector<Trajectory>& paths) {
  std::vector<std::string> columns;
  std::size_t rows = 0;
  for (const Trajectory& path : paths) {
    for (const char* what : {" cells", " seconds", " gap"}) columns.push_back(std::string(path.label).append(what));
    rows = std::max(rows, path.gap.size());
  }
  report::Csv csv(columns);
  for (std::size_t i = 0; i < rows; ++i) {
    std::vector<report::Csv::Cell> cells;
    for (const Trajectory& path : paths)
      for (const auto* column : {&path.cells, &path.seconds, &path.gap})
        cells.emplace_back(i < column->size() ? (*column)[i] : NAN);
    csv.row(cells);
  }
  return csv;
}

report::NamedPlot picture(const std::vector<Trajectory>& paths, const std::string& name, const std::string& caption,
                          const report::Axis& x, int column) {
  report::Panel panel{.title = "", .x = x, .y = {.label = "gap of R", .logarithmic = true}, .bands = {}, .curves = {}};
  for (int i = 0; i < std::ssize(paths); ++i)
    panel.curves.push_back({.x = 3 * i + column,
                            .y = 3 * i + 3,
                            .label = paths[static_cast<std::size_t>(i)].label,
                            .style = {.colour = i, .dash = i / report::LineStyle::kColours},
                            .steps = true});
  return {name, caption, report::Plot("The certified interval closes", table(paths), {panel})};
}

struct Gap {
  void bind(Parameters&) {}

  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<Sample> samples = {
        sample("noisy box", "shape:box?faces=20000&noise=0.002&rotate=random"),
        sample("bumpy blob", "shape:blob?faces=20000"), sample("triangle soup", "shape:soup?faces=1000"),
        sample("cylinder", "shape:cylinder?sides=64"), sample("sphere", "shape:sphere?kind=even&faces=2000")};
    if (!context.meshes.empty()) {
      samples.clear();
      for (const std::string& mesh : context.meshes)
        samples.push_back(sample(std::filesystem::path(mesh).filename().string(), mesh));
    }
    ExperimentResult result;
    std::vector<Trajectory> paths;
    for (std::size_t i = 0; i < samples.size(); ++i) {  // one by one, for their times
      if (context.on_progress) context.on_progress(i, samples.size(), samples[i].label);
      try {
        paths.push_back(follow(samples[i], context));
      } catch (const MeshError& e) {
        result.errors.push_back(e.what());
        continue;
      }
      const Trajectory& path = paths.back();
      result.data.push_back({{"label", path.label},
                             {"origin", samples[i].origin},
                             {"cells", path.result.cells},
                             {"seconds", path.seconds.back()},
                             {"gap", path.gap.back()},
                             {"closed", path.result.closed}});
    }
    if (paths.empty()) return result;
    const auto [fewest, most] =
        std::ranges::minmax(paths, {}, [](const Trajectory& path) { return path.result.cells; });
    const auto closed = std::ranges::count_if(paths, [](const Trajectory& path) { return path.result.closed; });
    result.says = std::to_string(closed) + " of " + std::to_string(paths.size()) + " proofs closed, after " +
                  std::to_string(fewest.result.cells) + " (" + fewest.label + ") to " +
                  std::to_string(most.result.cells) + " boxes (" + most.label + "); the paper leaves the optimum open";
    result.plots = {
        picture(paths, "gap-cells", "Each box of rotations costs about a microsecond.",
                {.label = "boxes of rotations", .logarithmic = true}, 1),
        picture(paths, "gap-seconds", "The same in time, on all cores.", {.label = "seconds", .logarithmic = true}, 2)};
    return result;
  }
};

}  // namespace

Experiment gap() {
  return make_experiment<Gap>("gap", "The certified interval closes: gap against boxes and seconds",
                              "meshes of different kinds", "");
}

}  // namespace rectilin::paper::figures
