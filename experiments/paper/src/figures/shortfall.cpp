// By how much searches fall short of the certified optimum: the paper's genetic algorithm on the paper's box and on one
// that covers all orientations, and thirty restarts of Nelder and Mead's method.
#include <algorithm>
#include <cmath>

#include "figures/experiments.h"
#include "rectilin/laboratory/plan.h"
#include "rectilin/laboratory/statistics.h"
#include "rectilin/measure/measure.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"

namespace rectilin::paper::figures {
namespace {

struct Search {
  std::string label, optimizer;
  const Domain& domain;
};

const std::vector<Search>& searches() {
  static const std::vector<Search> all = {{"GA, paper's box", "ga", paper_domain()},
                                          {"GA, covering box", "ga", covering_domain()},
                                          {"30 restarts of Nelder-Mead", "multistart?starts=30", covering_domain()}};
  return all;
}

/// The optimum is certified more finely here than elsewhere, so that small shortfalls can be told from none.
double resolution(const ExperimentContext& context) { return 1e-3 * context.gap; }

struct Row {
  std::string mesh, error;
  double optimum = 0;             // R, certified
  std::vector<double> shortfall;  // one element for each search
  std::vector<double> evaluations;
};

Row measured(const std::string& mesh, const ExperimentContext& context) {
  Row row;
  row.mesh = mesh;
  const ProjectedArea objective(area_vectors(context.load(mesh)));
  const RunSettings settings = {.seed = laboratory::instance(context.seed, mesh, 0).run_seed, .stop = context.stop};
  row.optimum = measure(objective, {.certify = {.gap = resolution(context)}, .run = settings}).value;
  for (const Search& search : searches()) {
    MeasureOptions options = measure_options(search.optimizer, all_optimizers());
    options.run = settings;
    options.run.domain = &search.domain;
    const Rectilinearity found = measure(objective, options);
    row.shortfall.push_back(std::max(0.0, row.optimum - found.value));
    row.evaluations.push_back(static_cast<double>(found.run.costs.evaluations()));
  }
  if (context.stop.stop_requested()) throw Stopped();
  return row;
}

/// Shapes whose optimum is known and others, each in several poses.
std::vector<std::string> own_meshes(int poses) {
  std::vector<std::string> meshes;
  for (const char* shape : {"box", "lshape", "pyramid", "prism?sides=6", "cylinder", "filleted-cube", "torus",
                            "ellipsoid", "blob?faces=2000", "soup?faces=200"})
    for (int pose = 1; pose <= poses; ++pose)
      meshes.push_back(std::string("shape:")
                           .append(shape)
                           .append(std::string(shape).find('?') == std::string::npos ? "?" : "&")
                           .append("rotate=random&seed=")
                           .append(std::to_string(pose)));
  return meshes;
}

constexpr double kTargets[] = {1e-2, 1e-3, 1e-4, 1e-6};

/// The results of one search: how often it falls short by more than each target, its worst shortfall, and where
/// that was.
Json summarise(const std::vector<Row>& rows, std::size_t search) {
  std::vector<double> shortfalls, evaluations;
  const Row* worst = nullptr;
  for (const Row& row : rows) {
    if (!row.error.empty()) continue;
    shortfalls.push_back(row.shortfall[search]);
    evaluations.push_back(row.evaluations[search]);
    if (worst == nullptr || row.shortfall[search] > worst->shortfall[search]) worst = &row;
  }
  Json within = Json::array();
  for (const double target : kTargets)
    within.push_back(
        {{"shortfall", target},
         {"share", static_cast<double>(std::ranges::count_if(shortfalls, [target](double s) { return s <= target; })) /
                       static_cast<double>(shortfalls.size())}});
  return {{"search", searches()[search].label},
          {"optimizer", searches()[search].optimizer},
          {"domain", searches()[search].domain.name()},
          {"within", within},
          {"median", laboratory::median(shortfalls)},
          {"worst", worst->shortfall[search]},
          {"worst_mesh", worst->mesh},
          {"median_evaluations", laboratory::median(evaluations)}};
}

/// Plots the share of the meshes on which a search falls short by more than x.
report::NamedPlot distribution(const std::vector<Row>& rows, double gap) {
  std::vector<std::string> columns = {"share"};
  std::vector<std::vector<double>> sorted(searches().size());
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    columns.push_back(searches()[s].label);
    for (const Row& row : rows)
      if (row.error.empty()) sorted[s].push_back(std::max(row.shortfall[s], gap));
    std::ranges::sort(sorted[s], std::greater());
  }
  report::Csv csv(columns);
  for (std::size_t i = 0; i < sorted.front().size(); ++i) {
    std::vector<report::Csv::Cell> cells = {static_cast<double>(i + 1) / static_cast<double>(sorted.front().size())};
    for (const auto& column : sorted) cells.emplace_back(column[i]);
    csv.row(cells);
  }
  report::Panel panel{
      .title = "",
      .x = {.label = "falls short by at least this much of R", .logarithmic = true, .lower = gap, .upper = 1},
      .y = {.label = "share of meshes", .lower = 0, .upper = 1},
      .bands = {},
      .curves = {}};
  for (int s = 0; s < std::ssize(sorted); ++s)
    panel.curves.push_back(
        {.x = s + 2, .y = 1, .label = searches()[static_cast<std::size_t>(s)].label, .style = {.colour = s}});
  return {"shortfall", "How far below the certified optimum each search ends; the further left, the better.",
          report::Plot("Falling short of the optimum", csv, {panel})};
}

struct Shortfall {
  int poses = 5;

  void bind(Parameters& parameters) {
    parameters.integer("poses", poses, 1, 1000, "random poses of each built-in shape");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    const std::vector<std::string> meshes = context.meshes.empty() ? own_meshes(poses) : context.meshes;
    std::vector<Row> rows(meshes.size());
    const auto keep = [&](std::size_t i, Outcome<Row>&& outcome) {
      if (outcome.value) rows[i] = std::move(*outcome.value);
      else rows[i].error = outcome.error;
    };
    const std::size_t done = for_each_in_order<Row>(
        meshes, [&](std::size_t i) { return measured(meshes[i], context); }, keep, context.loop());
    if (done < meshes.size()) throw Stopped();

    ExperimentResult result;
    for (const Row& row : rows)
      if (!row.error.empty()) result.errors.push_back(row.error);
    if (result.errors.size() == rows.size()) return result;
    Json summary = Json::array(), each = Json::array();
    for (std::size_t s = 0; s < searches().size(); ++s) {
      summary.push_back(summarise(rows, s));
      char text[96];
      std::snprintf(text, sizeof text, "%s%s within 1e-3 on %.1f %%, worst %.2g", s > 0 ? "; " : "",
                    searches()[s].label.c_str(), 100 * summary.back()["within"][1]["share"].get<double>(),
                    summary.back()["worst"].get<double>());
      result.says.append(text);
    }
    for (const Row& row : rows)
      if (row.error.empty())
        each.push_back({{"mesh", row.mesh}, {"optimum", row.optimum}, {"shortfall", row.shortfall}});
    result.data = {{"searches", std::move(summary)}, {"meshes", std::move(each)}};
    result.plots = {distribution(rows, resolution(context))};
    return result;
  }
};

}  // namespace

Experiment shortfall() {
  return make_experiment<Shortfall>("shortfall", "By how much searches fall short of the certified optimum",
                                    "meshes, or folders of them", "poses=1");
}

}  // namespace rectilin::paper::figures
