// The evaluation as a page for people.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "rectilin/report/html.h"
#include "writing.h"

namespace rectilin::evaluation {
namespace {

using report::html::escape;
using retrieval::named_measures;

std::string printed(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

std::string time_text(double seconds) {
  if (!(seconds > 0)) return "";
  if (seconds < 1e-3) return printed("%.3g µs", seconds * 1e6);
  return seconds < 1 ? printed("%.3g ms", seconds * 1e3) : printed("%.3g s", seconds);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + escape(name);
  return text;
}

std::string introduction(const Evaluation& e) {
  std::size_t queries = 0, classes = 0;
  for (const auto& q : e.results[0].scores.queries) queries += q.counts;
  for (const auto& c : e.results[0].scores.classes) classes += c.counts;
  std::string text = report::html::paragraph(
      std::to_string(e.classes.models.size()) + " models; each of " + std::to_string(queries) + " in " +
      std::to_string(classes) +
      " classes of more than two was a query, ranked against all others. The measures are those of the Princeton Shape "
      "Benchmark: nearest neighbour (NN), first and second tier (FT, ST), E of the first 32, discounted cumulative "
      "gain "
      "(DCG).");
  if (!e.missing.empty())
    text += report::html::paragraph("<b>" + std::to_string(e.missing.size()) + " models have no mesh file:</b> " +
                                    listed(e.missing) + ".");
  if (!e.errors.empty()) text += report::html::paragraph("<b>Meshes that failed:</b> " + listed(e.errors) + ".");
  if (!e.losses.empty())
    text += report::html::paragraph("<b>Meshes that are not all that their file holds:</b> " + listed(e.losses) + ".");
  if (!e.small_classes.empty())
    text += report::html::paragraph("Classes of one or two models, in no mean: " + listed(e.small_classes) + ".");
  if (!e.empty_classes.empty())
    text += report::html::paragraph("<b>Empty classes:</b> " + listed(e.empty_classes) + ".");
  return text;
}

/// The largest of a column is bold.
template <class Value>
std::vector<std::string> column_cells(const std::vector<Result>& results, const Value& value) {
  double most = 0;
  for (const Result& r : results) most = std::max(most, value(r));
  std::vector<std::string> cells;
  for (const Result& r : results)
    cells.push_back(value(r) == most && results.size() > 1 ? "<span class=best>" + percent(value(r)) + "</span>"
                                                           : percent(value(r)));
  return cells;
}

std::string scores_table(const Evaluation& e) {
  std::vector<std::string> header{""};
  std::vector<std::vector<std::string>> columns;
  for (const auto& m : named_measures()) {
    header.emplace_back(m.name);
    columns.push_back(column_cells(e.results, [&](const Result& r) { return r.scores.micro.*m.value; }));
  }
  header.insert(header.end(), {"DCG, 95 %", "macro NN", "macro DCG", "bytes", "a model", "a pair"});
  columns.push_back({});
  for (const Result& r : e.results)
    columns.back().push_back(percent(r.intervals.back().low) + " – " + percent(r.intervals.back().high));
  columns.push_back(column_cells(e.results, [](const Result& r) { return r.scores.macro.nearest; }));
  columns.push_back(column_cells(e.results, [](const Result& r) { return r.scores.macro.dcg; }));
  report::html::Table table(header);
  for (std::size_t i = 0; i < e.results.size(); ++i) {
    const Result& r = e.results[i];
    std::vector<std::string> row{escape(r.contestant.label)};
    for (const auto& column : columns) row.push_back(column[i]);
    row.push_back(r.bytes > 0 ? std::to_string(r.bytes) : "");
    row.push_back(time_text(r.describe_seconds));
    row.push_back(time_text(r.compare_seconds));
    table.row(row);
  }
  return report::html::heading("Scores") +
         report::html::paragraph(
             "Percent; means over the queries (micro), and over the classes of their means (macro). The "
             "interval is what DCG may be on other classes like these: a bootstrap over classes. Times are of "
             "one thread; a pose that several descriptors use is counted for the one that found it.") +
         table.text();
}

std::string tests_table(const Evaluation& e) {
  if (e.comparisons.empty()) return "";
  report::html::Table table({"", "difference of DCG", "95 %", "p", "p corrected"});
  for (const Comparison& c : e.comparisons) {
    const bool forward = c.difference.mean >= 0;
    const auto& better = e.results[forward ? c.first : c.second].contestant.label;
    const auto& worse = e.results[forward ? c.second : c.first].contestant.label;
    const double sign = forward ? 1 : -1;
    const double low = forward ? c.difference.low : -c.difference.high;
    const double high = forward ? c.difference.high : -c.difference.low;
    const std::string p = printed("%.2g", c.corrected);
    table.row({escape(better) + " over " + escape(worse), printed("%.2f", 100 * sign * c.difference.mean),
               printed("%.2f", 100 * low) + " – " + printed("%.2f", 100 * high), printed("%.2g", c.difference.p),
               c.corrected <= 0.05 ? "<span class=best>" + p + "</span>" : p});
  }
  return report::html::heading("Is it luck?") +
         report::html::paragraph(
             "DCG of the same queries by two descriptors, in percent points. Queries of one class are not "
             "independent, so the test turns the signs of whole classes (randomisation), and the interval "
             "resamples classes. Corrected: for all pairs (Holm). Bold: p at most 0.05.") +
         table.text();
}

std::string pictures(const std::vector<report::NamedPlot>& plots, const std::filesystem::path& out) {
  std::string text;
  for (const report::NamedPlot& plot : plots) {
    const std::string base = "plots/" + plot.name;
    const std::string files =
        "Data: " + report::html::link(base + ".csv", "CSV") + ", " + report::html::link(base + ".gp", "gnuplot") + ".";
    if (std::filesystem::exists(out / (base + ".svg")))
      text += report::html::picture(base + ".svg", plot.caption, files, plot.plot.width());
    else text += report::html::paragraph("(No picture.) " + escape(plot.caption) + " " + files);
  }
  return text.empty() ? text : report::html::heading("Pictures") + text;
}

std::string what_it_is(const Contestant& c) {
  switch (c.kind) {
    case Contestant::Kind::kMatrix:
      return "matrix " + escape(c.text);
    case Contestant::Kind::kLfdFiles:
      return "files of the light field descriptor in " + escape(c.text);
    case Contestant::Kind::kDescriptor:
      break;
  }
  return escape(c.text);
}

std::string what_they_are(const Evaluation& e) {
  report::html::Table table({"", "is", "distance", "does not depend on"});
  for (const Result& r : e.results)
    table.row({escape(r.contestant.label), what_it_is(r.contestant), escape(r.distance), escape(r.invariant)});
  return report::html::heading("What was compared") + table.text();
}

}  // namespace

std::string percent(double x) { return std::isnan(x) ? "–" : printed("%.1f", 100 * x); }

std::string page(const Evaluation& e, const std::vector<report::NamedPlot>& plots, const std::filesystem::path& out,
                 const Json& provenance) {
  const std::string files = report::html::paragraph(
      "Files: " + report::html::link("summary.json", "summary.json") + ", " +
      report::html::link("scores.csv", "scores") + ", " + report::html::link("classes.csv", "classes") + ", " +
      report::html::link("queries.csv", "queries") + ", " + report::html::link("tests.csv", "tests") + ", " +
      report::html::link("confusion.csv", "confusion") + "; " + report::html::link("matrices/", "matrices") +
      " in the benchmark's format.");
  return report::html::page(
      "Shape retrieval",
      introduction(e) + scores_table(e) + tests_table(e) + pictures(plots, out) + what_they_are(e) + files +
          report::html::details("Where these numbers come from", "<pre>" + escape(to_text(provenance, 1)) + "</pre>"));
}

}  // namespace rectilin::evaluation
