#include "rectilin/laboratory/plots.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "rectilin/base/printable.h"

namespace rectilin::laboratory {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string unit_name(Cost unit) { return unit == Cost::kEvaluations ? "evaluations" : "seconds"; }

/// Costs from the first step of any run to the end of the longest, evenly spaced on a log scale; whole numbers
/// for evaluations.
std::vector<double> cost_grid(const std::vector<const RunResult*>& runs, Cost unit) {
  double first = unit == Cost::kEvaluations ? 1 : kInfinity, last = first == 1 ? 2 : 0;
  for (const RunResult* run : runs) {
    const auto& steps = run->trace.cost(unit);
    if (!steps.empty()) first = std::min(first, std::max(steps.front(), 1e-6));
    last = std::max(last, run->spent(unit));
  }
  if (!(last > first)) return {};
  std::set<double> grid;
  constexpr int kPoints = 160;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = first * std::pow(last / first, static_cast<double>(i) / kPoints);
    grid.insert(unit == Cost::kEvaluations ? std::round(x) : x);
  }
  return {grid.begin(), grid.end()};
}

std::vector<const RunResult*> runs_on(const Results& results, std::size_t mesh) {
  std::vector<const RunResult*> runs;
  for (const RunResult& run : results.runs)
    if (run.mesh == mesh) runs.push_back(&run);
  return runs;
}

/// A column of costs, and the columns low, median, high of each entry.
report::Csv convergence_table(const Results& results, std::size_t mesh, Cost unit) {
  std::vector<std::string> columns = {unit_name(unit)};
  std::vector<std::vector<const RunResult*>> runs;
  for (std::size_t e = 0; e < results.plan.entries.size(); ++e) {
    const std::string& label = results.plan.entries[e].label;
    for (const char* which : {" 10 %", " median", " 90 %"}) columns.push_back(label + which);
    runs.push_back(results.of(mesh, e));
  }
  report::Csv table(columns);
  for (const double cost : cost_grid(runs_on(results, mesh), unit)) {
    std::vector<report::Csv::Cell> row = {cost};
    for (const auto& of_entry : runs) {
      std::vector<double> gaps;
      for (const RunResult* run : of_entry) gaps.push_back(run->trace.gap_after(unit, cost));
      for (const double p : {0.1, 0.5, 0.9}) row.push_back(gap_quantile(gaps, p));
    }
    table.row(row);
  }
  return table;
}

/// Coordinates that hold all gaps on the mesh.
report::Panel convergence_axes(const Results& results, std::size_t mesh, Cost unit) {
  double least = 0.1;
  const auto runs = runs_on(results, mesh);
  for (const RunResult* run : runs) least = std::min(least, run->trace.final_gap());
  report::Panel panel;
  const std::vector<double> grid = cost_grid(runs, unit);
  panel.x = {unit_name(unit), true, grid.empty() ? 0 : grid.front(), grid.empty() ? 0 : grid.back()};
  panel.y = {"gap", true, least / 3, 2};
  return panel;
}

std::string convergence_name(const Results& results, std::size_t mesh, Cost unit, const std::string& kind) {
  return kind + "-" + std::to_string(mesh + 1) + "-" + slug(results.meshes[mesh].title) + "-" + unit_name(unit);
}

/// Costs at which an entry's runs reach targets, over all meshes; infinite where they do not.
std::vector<double> runtimes(const Results& results, std::size_t entry, Cost unit) {
  std::vector<double> costs;
  for (const RunResult& run : results.runs) {
    if (run.entry != entry) continue;
    for (const double target : targets())
      if (decidable(results.meshes[run.mesh], target)) costs.push_back(run.trace.cost_to(unit, target));
  }
  std::ranges::sort(costs);
  return costs;
}

/// One panel with a step curve of shares for each entry; `sorted` are the values whose distribution it is.
report::NamedPlot distribution_plot(const Results& results, const std::string& name, const std::string& title,
                                    const report::Axis& x, const std::string& share, const std::vector<double>& grid,
                                    const std::vector<std::vector<double>>& sorted) {
  std::vector<std::string> columns = {x.label};
  report::Panel panel;
  panel.x = x;
  panel.y = {share, false, 0, 1};
  const std::vector<report::LineStyle> style = styles(results.plan);
  for (std::size_t e = 0; e < sorted.size(); ++e) {
    columns.push_back(results.plan.entries[e].label);
    panel.curves.push_back({1, static_cast<int>(e) + 2, columns.back(), style[e], true});
  }
  report::Csv table(columns);
  for (const double at : grid) {
    std::vector<report::Csv::Cell> row = {at};
    for (const auto& values : sorted)
      row.push_back(values.empty() ? kNone
                                   : static_cast<double>(std::ranges::upper_bound(values, at) - values.begin()) /
                                         static_cast<double>(values.size()));
    table.row(row);
  }
  return {name, "", report::Plot(title, table, {panel})};
}

}  // namespace

std::string slug(const std::string& text) {
  constexpr std::size_t kColumns = 48, kBytes = 120;
  std::string result;
  for (const char c : shortened(text, kColumns)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte)) result += c;
    else if (!result.empty() && result.back() != '-') result += '-';
  }
  if (result.size() > kBytes) {  // of characters that take many bytes each, or of marks that take no room
    std::size_t end = kBytes;
    while (end > 0 && (static_cast<unsigned char>(result[end]) & 0xC0) == 0x80) --end;
    result.resize(end);
  }
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result.empty() ? "unnamed" : result;
}

std::vector<std::string> unique_slugs(const std::vector<std::string>& texts) {
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (const std::string& text : texts) {
    const std::string first = slug(text);
    std::string name = first;
    for (int count = 2; !taken.insert(name).second; ++count) name = first + "-" + std::to_string(count);
    result.push_back(name);
  }
  return result;
}

std::vector<report::LineStyle> styles(const Plan& plan) {
  std::map<std::string, int> optimizers, variants;  // in order of appearance
  int most = 1;
  for (const Entry& entry : plan.entries) {
    optimizers.emplace(entry.spec, static_cast<int>(optimizers.size()));
    most = std::max(most, ++variants[entry.spec]);
  }
  variants.clear();
  std::vector<report::LineStyle> result;
  for (const Entry& entry : plan.entries) {
    const int i = optimizers[entry.spec];
    result.push_back(
        {i % report::LineStyle::kColours, i / report::LineStyle::kColours * most + variants[entry.spec]++});
  }
  return result;
}

report::NamedPlot convergence_plot(const Results& results, std::size_t mesh, Cost unit) {
  report::Panel panel = convergence_axes(results, mesh, unit);
  const std::vector<report::LineStyle> style = styles(results.plan);
  for (std::size_t e = 0; e < results.plan.entries.size(); ++e)
    panel.curves.push_back({1, 3 * static_cast<int>(e) + 3, results.plan.entries[e].label, style[e]});
  return {convergence_name(results, mesh, unit, "convergence"), "Median gap against " + unit_name(unit) + ".",
          report::Plot(results.meshes[mesh].title + ": median gap", convergence_table(results, mesh, unit), {panel})};
}

report::NamedPlot band_plot(const Results& results, std::size_t mesh, Cost unit) {
  const report::Panel axes = convergence_axes(results, mesh, unit);
  const std::vector<report::LineStyle> style = styles(results.plan);
  std::vector<report::Panel> panels;
  const int entries = static_cast<int>(results.plan.entries.size());
  for (int e = 0; e < entries; ++e) {
    report::Panel& panel = panels.emplace_back(axes);
    panel.title = results.plan.entries[e].label;
    panel.x.label.clear();
    panel.y.label.clear();
    panel.bands.push_back({1, 3 * e + 2, 3 * e + 4, style[e]});
    for (int other = 0; other < entries; ++other)
      if (other != e) panel.curves.push_back({.x = 1, .y = 3 * other + 3, .label = "", .style = {}, .faint = true});
    panel.curves.push_back({1, 3 * e + 3, "", style[e]});
  }
  return {convergence_name(results, mesh, unit, "bands"),
          "The same, one panel an optimizer: median and the band from the 10 % to the 90 % quantile; grey: the "
          "medians of the others.",
          report::Plot(results.meshes[mesh].title + ": gap against " + unit_name(unit),
                       convergence_table(results, mesh, unit), panels, std::min(4, std::max(2, entries)))};
}

report::NamedPlot runtime_plot(const Results& results, Cost unit) {
  std::vector<const RunResult*> runs;
  for (const RunResult& run : results.runs) runs.push_back(&run);
  const std::vector<double> grid = cost_grid(runs, unit);
  std::vector<std::vector<double>> costs;
  for (std::size_t e = 0; e < results.plan.entries.size(); ++e) costs.push_back(runtimes(results, e, unit));
  report::Axis x{unit_name(unit), true, grid.empty() ? 0 : grid.front(), grid.empty() ? 0 : grid.back()};
  report::NamedPlot plot =
      distribution_plot(results, "runtimes-" + unit_name(unit), "Runtimes over all meshes and targets", x,
                        "share of runs and targets", grid, costs);
  plot.caption =
      "Share of all pairs of a run and a target (gaps of 0.32, 0.1, 0.032, ... 1e-9) reached within so many " +
      unit_name(unit) + ".";
  return plot;
}

report::NamedPlot profile_plot(const Results& results, const Summary& summary) {
  const std::size_t entries = results.plan.entries.size();
  std::vector<std::vector<double>> ratios(entries);
  double largest = 10;
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
    for (std::size_t t = 0; t < targets().size(); ++t) {
      if (!decidable(results.meshes[mesh], targets()[t])) continue;
      double best = kInfinity;
      for (const auto& row : summary.cells) best = std::min(best, row[mesh].to_target[t].expected());
      for (std::size_t e = 0; e < entries; ++e) {
        const double mine = summary.cells[e][mesh].to_target[t].expected();
        ratios[e].push_back(std::isfinite(mine) ? mine / best : kInfinity);
        if (std::isfinite(mine)) largest = std::max(largest, mine / best);
      }
    }
  }
  for (auto& list : ratios) std::ranges::sort(list);
  std::vector<double> grid;
  constexpr int kPoints = 160;
  for (int i = 0; i <= kPoints; ++i) grid.push_back(std::pow(largest, static_cast<double>(i) / kPoints));
  report::NamedPlot plot = distribution_plot(results, "profile", "Performance profile",
                                             {"factor of the best expected running time", true, 1, largest},
                                             "share of problems", grid, ratios);
  plot.caption =
      "Share of the problems (a mesh and a target) on which an optimizer's expected running time is within a factor "
      "of the best optimizer's. Left end: how often it is the best; right end: how much it solves at all.";
  return plot;
}

report::NamedPlot heat_plot(const Results& results, const Summary& summary) {
  report::HeatMap map{"Median final gap", "log10 of the gap", {}, {}, {}};
  std::vector<std::size_t> shown;
  std::vector<std::string> header = {"optimizer"};
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
    if (!results.meshes[mesh].error.empty()) continue;
    shown.push_back(mesh);
    map.columns.push_back(results.meshes[mesh].title);
    header.push_back(results.meshes[mesh].title);
  }
  report::Csv table(header);
  for (const std::size_t e : summary.order(summary.budgets.size() - 1)) {
    map.rows.push_back(results.plan.entries[e].label);
    std::vector<double>& values = map.values.emplace_back();
    std::vector<report::Csv::Cell> row = {results.plan.entries[e].label};
    for (const std::size_t mesh : shown) {
      values.push_back(std::log10(summary.cells[e][mesh].median));
      row.push_back(values.back());
    }
    table.row(row);
  }
  return {"heat", "log10 of the median final gap; optimizers by their mean rank, the best at the top.",
          report::Plot(table, map)};
}

}  // namespace rectilin::laboratory
