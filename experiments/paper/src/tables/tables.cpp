// Tables 2 to 6 and Fig. 22.
#include "figures/experiments.h"
#include "tables/retrieval_table.h"
#include "tables/rows.h"

namespace rectilin::paper::figures {
namespace {

/// Precision-recall curves of all rows of tables 4 and 5.
ExperimentResult precision_recall(const tables::ScoredTable& table) {
  ExperimentResult result;
  result.errors = table.errors;
  std::vector<std::string> columns{"recall"};
  for (const auto& row : table.rows) columns.push_back(row.row.label);
  report::Csv data(columns);
  for (std::size_t j = 0; j < retrieval::kRecalls; ++j) {
    std::vector<report::Csv::Cell> cells{static_cast<double>(j + 1) / static_cast<double>(retrieval::kRecalls)};
    for (const auto& row : table.rows) cells.emplace_back(row.scores.precision[j]);
    data.row(cells);
  }
  const int half = static_cast<int>(table.rows.size()) / 2;
  std::vector<report::Panel> panels;
  int better = 0;
  for (int i = 0; i < half; ++i) {
    const auto& alone = table.rows[static_cast<std::size_t>(i)];
    const auto& with_r = table.rows[static_cast<std::size_t>(half + i)];
    report::Panel panel;
    panel.title = alone.row.label;
    panel.x = {.label = "recall", .lower = 0, .upper = 1, .step = 0.5};
    panel.y = {.label = "precision", .lower = 0, .upper = 1, .step = 0.5};
    panel.curves.push_back({.x = 1, .y = i + 2, .label = "alone", .style = {0, 1}});
    panel.curves.push_back({.x = 1, .y = half + i + 2, .label = "with R", .style = {1, 0}});
    panels.push_back(panel);
    better += with_r.scores.micro.dcg > alone.scores.micro.dcg;
    result.data.push_back(
        {{"row", alone.row.label}, {"dcg", alone.scores.micro.dcg}, {"dcg_with_r", with_r.scores.micro.dcg}});
  }
  result.says = "on " + table.collection + ": R improves " + std::to_string(better) + " of " + std::to_string(half) +
                " descriptors in DCG (paper: all)";
  result.plots.push_back({"fig22", "Precision and recall of each descriptor alone (dashed) and with R.",
                          report::Plot("Precision and recall", std::move(data), panels, 3)});
  return result;
}

/// A table as an experiment: `Which` supplies name, title and rows.
template <class Which>
struct TableExperiment {
  tables::TableSettings settings;
  void bind(Parameters& parameters) { settings.bind(parameters); }
  ExperimentResult run(const ExperimentContext& context) const {
    return tables::present(Which::kName, Which::kTitle, tables::score(Which::rows(), settings, context));
  }
  static Experiment make() {
    return make_experiment<TableExperiment>(Which::kName, Which::kTitle, "", "models=3&size=32");
  }
};

struct Table2 {
  static constexpr const char *kName = "table2", *kTitle = "Table 2: silhouettes from 6 to 258 views, and LFD";
  static std::vector<tables::Row> rows() { return tables::table2_rows(); }
};
struct Table3 {
  static constexpr const char *kName = "table3", *kTitle = "Table 3: poses and ways to match";
  static std::vector<tables::Row> rows() { return tables::table3_rows(); }
};
struct Table4 {
  static constexpr const char *kName = "table4", *kTitle = "Table 4: descriptors without rectilinearity";
  static std::vector<tables::Row> rows() { return tables::table4_rows(); }
};
struct Table5 {
  static constexpr const char *kName = "table5", *kTitle = "Table 5: the same with rectilinearity";
  static std::vector<tables::Row> rows() { return tables::table5_rows(); }
};
struct Table6 {
  static constexpr const char *kName = "table6", *kTitle = "Table 6: beside other methods";
  static std::vector<tables::Row> rows() { return tables::table6_rows(); }
};

struct Figure22 {
  tables::TableSettings settings;
  void bind(Parameters& parameters) { settings.bind(parameters); }
  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<tables::Row> rows = tables::table4_rows();
    for (const tables::Row& row : tables::table5_rows()) rows.push_back(row);
    return precision_recall(tables::score(rows, settings, context));
  }
};

}  // namespace

Experiment table2() { return TableExperiment<Table2>::make(); }
Experiment table3() { return TableExperiment<Table3>::make(); }
Experiment table4() { return TableExperiment<Table4>::make(); }
Experiment table5() { return TableExperiment<Table5>::make(); }
Experiment table6() { return TableExperiment<Table6>::make(); }
Experiment fig22() {
  return make_experiment<Figure22>("fig22", "Precision and recall with and without rectilinearity", "",
                                   "models=3&size=32");
}

}  // namespace rectilin::paper::figures
