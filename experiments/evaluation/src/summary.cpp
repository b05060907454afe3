// The evaluation as files for programs: JSON and CSV.
#include <algorithm>
#include <cmath>

#include "rectilin/base/whole_file.h"
#include "rectilin/report/csv.h"
#include "writing.h"

namespace rectilin::evaluation {
namespace {

namespace fs = std::filesystem;
using retrieval::named_measures;

std::string file_name(std::string label) {
  std::ranges::replace(label, '/', '_');
  return label;
}

Json measures_json(const retrieval::Measures& measures) {
  Json json = Json::object();
  for (const auto& m : named_measures()) json[m.name] = measures.*m.value;
  return json;
}

std::vector<std::string> with_measures(std::vector<std::string> columns, const std::string& prefix = "") {
  for (const auto& m : named_measures()) columns.push_back(prefix + m.name);
  return columns;
}

void add_measures(std::vector<report::Csv::Cell>& row, const retrieval::Measures& measures) {
  for (const auto& m : named_measures()) row.emplace_back(measures.*m.value);
}

report::Csv scores_csv(const Evaluation& evaluation) {
  report::Csv table(with_measures(
      with_measures({"label", "descriptor", "bytes", "describe_seconds", "compare_seconds"}, "micro_"), "macro_"));
  for (const Result& r : evaluation.results) {
    std::vector<report::Csv::Cell> row{r.contestant.label, r.contestant.text, r.bytes, r.describe_seconds,
                                       r.compare_seconds};
    add_measures(row, r.scores.micro);
    add_measures(row, r.scores.macro);
    table.row(row);
  }
  return table;
}

report::Csv classes_table(const Evaluation& evaluation) {
  report::Csv table(with_measures({"label", "class", "models", "in_means"}));
  for (const Result& r : evaluation.results)
    for (std::size_t c = 0; c < r.scores.classes.size(); ++c) {
      const auto& score = r.scores.classes[c];
      std::vector<report::Csv::Cell> row{r.contestant.label, evaluation.classes.path(c), score.models,
                                         score.counts ? 1 : 0};
      add_measures(row, score.mean);
      table.row(row);
    }
  return table;
}

report::Csv queries_table(const Evaluation& evaluation) {
  report::Csv table(with_measures({"label", "model", "class", "in_means"}));
  for (const Result& r : evaluation.results)
    for (std::size_t q = 0; q < r.scores.queries.size(); ++q) {
      const auto& score = r.scores.queries[q];
      std::vector<report::Csv::Cell> row{r.contestant.label, evaluation.classes.models[q],
                                         evaluation.classes.path(evaluation.classes.class_of[q]), score.counts ? 1 : 0};
      add_measures(row, score.measures);
      table.row(row);
    }
  return table;
}

report::Csv tests_csv(const Evaluation& evaluation) {
  report::Csv table({"first", "second", "dcg_difference", "low", "high", "p", "p_holm"});
  for (const Comparison& c : evaluation.comparisons)
    table.row({evaluation.results[c.first].contestant.label, evaluation.results[c.second].contestant.label,
               c.difference.mean, c.difference.low, c.difference.high, c.difference.p, c.corrected});
  return table;
}

report::Csv confusion_table(const Evaluation& evaluation) {
  report::Csv table({"label", "class", "nearest_is_of", "queries"});
  for (const Result& r : evaluation.results) {
    const auto counts = retrieval::confusion(r.matrix, evaluation.classes);
    for (std::size_t a = 0; a < counts.size(); ++a)
      for (std::size_t b = 0; b < counts.size(); ++b)
        if (counts[a][b] > 0)
          table.row({r.contestant.label, evaluation.classes.path(a), evaluation.classes.path(b), counts[a][b]});
  }
  return table;
}

}  // namespace

void write_result(const fs::path& out, const Result& result, const retrieval::Classification& classes) {
  const fs::path base = out / "matrices" / file_name(result.contestant.label);
  std::string rows;
  for (const std::string& model : classes.models) rows += model + '\n';
  retrieval::write_matrix(base.string() + ".matrix", result.matrix);
  write_whole_file(base.string() + ".models", rows);
}

const char* kind_name(Contestant::Kind kind) {
  switch (kind) {
    case Contestant::Kind::kMatrix:
      return "matrix";
    case Contestant::Kind::kLfdFiles:
      return "lfd_files";
    case Contestant::Kind::kDescriptor:
      break;
  }
  return "descriptor";
}

Json summary(const Evaluation& evaluation, const Json& provenance) {
  Json results = Json::array();
  for (const Result& r : evaluation.results) {
    Json intervals = Json::object(), precision = Json::array();
    for (std::size_t m = 0; m < r.intervals.size(); ++m)
      intervals[named_measures()[m].name] = {r.intervals[m].low, r.intervals[m].high};
    for (const double p : r.scores.precision) precision.push_back(std::isnan(p) ? Json(nullptr) : Json(p));
    results.push_back({{"label", r.contestant.label},
                       {kind_name(r.contestant.kind), r.contestant.text},
                       {"bytes", r.bytes},
                       {"distance", r.distance},
                       {"invariant_to", r.invariant},
                       {"describe_seconds", r.describe_seconds},
                       {"compare_seconds", r.compare_seconds},
                       {"micro", measures_json(r.scores.micro)},
                       {"micro_interval_95", intervals},
                       {"macro", measures_json(r.scores.macro)},
                       {"precision_at_recall_0.05_to_1", precision}});
  }
  Json tests = Json::array();
  for (const Comparison& c : evaluation.comparisons)
    tests.push_back({{"first", evaluation.results[c.first].contestant.label},
                     {"second", evaluation.results[c.second].contestant.label},
                     {"dcg_difference", c.difference.mean},
                     {"interval_95", {c.difference.low, c.difference.high}},
                     {"p", c.difference.p},
                     {"p_holm", c.corrected}});
  return {{"models", evaluation.classes.models.size()},
          {"missing", evaluation.missing},
          {"failed", evaluation.failed},
          {"errors", evaluation.errors},
          {"left_out", evaluation.losses},
          {"empty_classes", evaluation.empty_classes},
          {"small_classes", evaluation.small_classes},
          {"results", results},
          {"tests", tests},
          {"provenance", provenance}};
}

report::PictureTroubles write_report(const fs::path& out, const Evaluation& evaluation, const Json& provenance) {
  scores_csv(evaluation).write(out / "scores.csv");
  classes_table(evaluation).write(out / "classes.csv");
  queries_table(evaluation).write(out / "queries.csv");
  tests_csv(evaluation).write(out / "tests.csv");
  confusion_table(evaluation).write(out / "confusion.csv");
  write_whole_file(out / "summary.json", to_text(summary(evaluation, provenance), 1) + '\n');
  const std::vector<report::NamedPlot> plots = figures(evaluation);
  fs::create_directories(out / "plots");
  std::vector<std::string> names;
  for (const report::NamedPlot& plot : plots) {
    plot.plot.write(out / "plots", plot.name);
    names.push_back(plot.name);
  }
  const report::PictureTroubles troubles = report::draw_all(out / "plots", names);
  write_whole_file(out / "index.html", page(evaluation, plots, out, provenance));
  return troubles;
}

}  // namespace rectilin::evaluation
