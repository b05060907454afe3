// Tables 2 to 6 and Fig. 22.
#include "figures/experiments.h"
#include "rectilin/retrieval/poses.h"
#include "tables/retrieval_table.h"

namespace rectilin::paper::figures {
namespace {

using tables::kNone;
using tables::Row;

constexpr const char* kSilhouettes = "gsmd?image=silhouette&size=$size";
constexpr const char* kGsmd = "gsmd?size=$size";
// Weights of sums of descriptors, cross-validated on the benchmark's training half (papers/retrieval.md).
constexpr const char* kWithR = "+0.1*r";

std::string views(const char* base, int count) { return std::string(base) + "&views=" + std::to_string(count); }

std::vector<Row> table2_rows() {
  return {{"GSMD_258", views(kSilhouettes, 258), {65.8, 40.6, 50.9, 65.9}},
          {"GSMD_66", views(kSilhouettes, 66), {67.9, 40.8, 51.3, 66.4}},
          {"GSMD_18", views(kSilhouettes, 18), {65.8, 40.1, 50.3, 65.6}},
          {"GSMD_6", views(kSilhouettes, 6), {62.0, 35.2, 45.8, 62.2}},
          {"LFD", "lfd?size=$size", {65.0, 38.3, 48.7, 64.4}},
          {"LFD as coded", "lfd:ntu?size=$size", {65.7, 38.0, 48.7, 64.3}}};
}

/// Table 3: poses and ways to match. The rows with principal axes are included only if such poses are available.
std::vector<Row> table3_rows() {
  const std::string base = std::string(kSilhouettes) + "&views=66";
  std::vector<Row> rows{{"rectilinear, 24", base, {67.9, 40.8, 51.3, 66.4}}};
  const auto add = [&](const char* label, const std::string& pose, const char* match, tables::PaperScores paper) {
    for (const auto& [name, meaning] : retrieval::pose_names())
      if (name == pose) rows.push_back({label, base + "&pose=" + pose + "&match=" + match, paper});
  };
  add("rect24", "cpn", "all", {67.9, 40.8, 51.3, 66.4});
  add("pca24", "pca", "all", {65.9, 40.3, 50.9, 66.0});
  add("pca4", "pca-ordered", "turns", {65.7, 39.0, 49.5, 65.1});
  add("pca", "pca-definite", "one", {65.0, 38.2, 48.5, 64.4});
  return rows;
}

std::vector<Row> table4_rows() {
  return {{"D1", "d1", {25.7, 13.1, 19.3, 40.6}},
          {"D2", "d2", {33.7, 16.4, 24.5, 44.4}},
          {"SHD", "shd", {56.9, 28.8, 38.5, 57.2}},
          {"LFD", "lfd?size=$size", {65.0, 38.3, 48.7, 64.4}},
          {"GSMD", kGsmd, {67.1, 41.8, 52.0, 67.0}},
          {"GSMD + SHD", std::string(kGsmd) + "+0.5*shd", {71.8, 44.5, 56.2, 69.8}}};
}

std::vector<Row> table5_rows() {
  return {{"D1 + R", "d1+0.5*r", {34.2, 18.7, 28.2, 46.8}},
          {"D2 + R", "d2+0.5*r", {43.0, 22.2, 32.0, 50.1}},
          {"SHD + R", "shd+0.3*r", {62.2, 33.2, 45.2, 61.5}},
          {"LFD + R", std::string("lfd?size=$size") + kWithR, {67.5, 41.3, 53.6, 67.3}},
          {"GSMD + R", std::string(kGsmd) + kWithR, {69.2, 44.2, 56.3, 69.4}},
          {"GSMD + SHD + R", std::string(kGsmd) + "+0.5*shd+0.15*r", {73.1, 47.2, 60.2, 72.1}}};
}

std::vector<Row> table6_rows() {
  return {table5_rows().back(),
          {"MDLA-DPD (cited)", "", {68.8, 43.6, 54.2, 67.8}},
          {"LFD + AAD + SPRH", "lfd:ntu?size=$size+0.3*aad+0.3*sprh", {kNone, 42.7, 52.7, kNone}},
          {"LFD (PSB)", "lfd:ntu?size=$size", {65.7, 38.0, 48.7, 64.3}},
          {"SWC (cited)", "", {46.9, 31.4, 39.7, 65.4}}};
}

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
  result.plots.push_back({"fig22", "Precision and recall of each descriptor alone and with R.",
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
  static std::vector<Row> rows() { return table2_rows(); }
};
struct Table3 {
  static constexpr const char *kName = "table3", *kTitle = "Table 3: poses and ways to match";
  static std::vector<Row> rows() { return table3_rows(); }
};
struct Table4 {
  static constexpr const char *kName = "table4", *kTitle = "Table 4: descriptors without rectilinearity";
  static std::vector<Row> rows() { return table4_rows(); }
};
struct Table5 {
  static constexpr const char *kName = "table5", *kTitle = "Table 5: the same with rectilinearity";
  static std::vector<Row> rows() { return table5_rows(); }
};
struct Table6 {
  static constexpr const char *kName = "table6", *kTitle = "Table 6: beside other methods";
  static std::vector<Row> rows() { return table6_rows(); }
};

struct Figure22 {
  tables::TableSettings settings;
  void bind(Parameters& parameters) { settings.bind(parameters); }
  ExperimentResult run(const ExperimentContext& context) const {
    std::vector<Row> rows = table4_rows();
    rows[rows.size() - 1] = {"GSMD + SHD", std::string(kGsmd) + "+0.5*shd", {}};
    for (const Row& row : table5_rows()) rows.push_back(row);
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
