// The evaluation's pictures.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "writing.h"

namespace rectilin::evaluation {
namespace {

report::NamedPlot precision_recall(const Evaluation& evaluation) {
  std::vector<std::string> columns{"recall"};
  for (const Result& r : evaluation.results) columns.push_back(r.contestant.label);
  report::Csv data(columns);
  for (std::size_t j = 0; j < retrieval::kRecalls; ++j) {
    std::vector<report::Csv::Cell> row{static_cast<double>(j + 1) / static_cast<double>(retrieval::kRecalls)};
    for (const Result& r : evaluation.results) row.emplace_back(r.scores.precision[j]);
    data.row(row);
  }
  report::Panel panel;
  panel.x = {.label = "recall", .lower = 0, .upper = 1, .step = 0.2};
  panel.y = {.label = "precision", .lower = 0, .upper = 1, .step = 0.2};
  for (std::size_t i = 0; i < evaluation.results.size(); ++i) {
    const int k = static_cast<int>(i);
    panel.curves.push_back({.x = 1,
                            .y = k + 2,
                            .label = evaluation.results[i].contestant.label,
                            .style = {k % report::LineStyle::kColours, k / report::LineStyle::kColours}});
  }
  return {"precision-recall",
          "Mean precision at each recall. A query joins where one hit is not already a higher recall.",
          report::Plot("", std::move(data), {panel})};
}

report::NamedPlot class_map(const Evaluation& evaluation) {
  report::HeatMap map;
  map.title = "DCG by class";
  map.scale = "DCG";
  for (const Result& r : evaluation.results) map.columns.push_back(r.contestant.label);
  std::vector<std::string> columns{"class"};
  columns.insert(columns.end(), map.columns.begin(), map.columns.end());
  report::Csv data(columns);
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < evaluation.classes.classes.size(); ++c)
    if (evaluation.results[0].scores.classes[c].counts) order.push_back(c);
  const auto best = [&](std::size_t c) {
    double most = 0;
    for (const Result& r : evaluation.results) most = std::max(most, r.scores.classes[c].mean.dcg);
    return most;
  };
  std::ranges::stable_sort(order, std::greater<>(), best);
  for (const std::size_t c : order) {
    map.rows.push_back(evaluation.classes.classes[c].name);
    std::vector<report::Csv::Cell> row{map.rows.back()};
    map.values.emplace_back();
    for (const Result& r : evaluation.results) {
      map.values.back().push_back(r.scores.classes[c].mean.dcg);
      row.emplace_back(map.values.back().back());
    }
    data.row(row);
  }
  return {"classes", "Mean DCG of the queries of each class, by the best first.", report::Plot(std::move(data), map)};
}

/// Nearest neighbours of the contestant with the largest DCG; classes that are always found, and found by none else,
/// are left out. Nothing if no class is left.
std::optional<report::NamedPlot> confusion_map(const Evaluation& evaluation) {
  const auto best =
      std::ranges::max_element(evaluation.results, {}, [](const Result& r) { return r.scores.micro.dcg; });
  const auto counts = retrieval::confusion(best->matrix, evaluation.classes);
  std::vector<std::size_t> shown;
  for (std::size_t a = 0; a < counts.size(); ++a) {
    std::size_t wrong = 0;
    for (std::size_t b = 0; b < counts.size(); ++b)
      if (a != b) wrong += counts[a][b] + counts[b][a];
    if (wrong > 0) shown.push_back(a);
  }
  constexpr std::size_t kMost = 40;  // rows that can be read
  std::ranges::stable_sort(shown, std::greater<>(), [&](std::size_t a) {
    return std::accumulate(counts[a].begin(), counts[a].end(), std::size_t{0}) - counts[a][a];
  });
  if (shown.empty()) return std::nullopt;
  if (shown.size() > kMost) shown.resize(kMost);
  std::ranges::sort(shown);
  report::HeatMap map;
  map.title = "Nearest neighbours by " + best->contestant.label;
  map.scale = "share of the row's queries";
  std::vector<std::string> columns{"class"};
  for (const std::size_t c : shown) {
    map.rows.push_back(evaluation.classes.classes[c].name);
    map.columns.push_back(map.rows.back());
    columns.push_back(map.rows.back());
  }
  report::Csv data(columns);
  for (const std::size_t a : shown) {
    std::vector<report::Csv::Cell> row{evaluation.classes.classes[a].name};
    map.values.emplace_back();
    const double all = static_cast<double>(evaluation.classes.classes[a].models.size());
    for (const std::size_t b : shown) {
      const double share = static_cast<double>(counts[a][b]) / all;
      map.values.back().push_back(counts[a][b] > 0 ? share : std::numeric_limits<double>::quiet_NaN());
      row.emplace_back(map.values.back().back());
    }
    data.row(row);
  }
  return report::NamedPlot{
      "confusion",
      "Class of the nearest model (column) by class of the query (row), for the classes with the most mistakes. "
      "White: never.",
      report::Plot(std::move(data), map)};
}

}  // namespace

std::vector<report::NamedPlot> figures(const Evaluation& evaluation) {
  std::vector<report::NamedPlot> plots;
  const bool any = std::ranges::any_of(evaluation.results[0].scores.classes, [](const auto& c) { return c.counts; });
  if (!any) return plots;
  plots.push_back(precision_recall(evaluation));
  plots.push_back(class_map(evaluation));
  if (auto map = confusion_map(evaluation)) plots.push_back(std::move(*map));
  return plots;
}

}  // namespace rectilin::evaluation
