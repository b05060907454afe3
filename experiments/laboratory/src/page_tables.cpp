#include "page_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "rectilin/laboratory/plots.h"
#include "rectilin/optim/evaluator.h"
#include "rectilin/report/html.h"

namespace rectilin::laboratory {
namespace {

using report::html::escape;
using report::html::paragraph;
using report::html::Table;

std::string printed(const char* format, double x) {
  if (std::isnan(x)) return "<span class=\"none\">-</span>";
  if (std::isinf(x)) return "<span class=\"none\">never</span>";
  char text[400];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

std::string gap_text(double gap) { return "<span class=\"number\">" + printed("%.1e", gap) + "</span>"; }
std::string percent(double share) { return printed("%.0f %%", 100 * share); }

/// Degrees; what rounds to zero has no sign.
std::string angle(double degrees) { return printed("%.4f", std::round(degrees * 1e4) / 1e4 + 0.0); }

std::string best(bool is_best, const std::string& html) {
  return is_best ? "<span class=\"best\">" + html + "</span>" : html;
}

/// The label behind the line that stands for it in plots.
std::string entry_name(const Results& results, std::size_t entry) {
  const report::LineStyle style = styles(results.plan)[entry];
  return "<svg class=\"line\" viewBox=\"0 0 28 9\" aria-hidden=\"true\"><line x2=\"28\" y1=\"5\" y2=\"5\" "
         "stroke-width=\"3\" stroke=\"" +
         report::hex_colour(style.colour) + "\" stroke-dasharray=\"" + report::dash_pattern(style.dash) + "\"/></svg>" +
         escape(results.plan.entries[entry].label);
}

std::size_t last_budget(const Summary& summary) { return summary.budgets.size() - 1; }

/// Place among targets() of 10^exponent.
std::size_t power_of_ten(int exponent) {
  const auto near = [&](double target) { return std::abs(std::log10(target) - exponent) < 0.1; };
  return static_cast<std::size_t>(std::ranges::find_if(targets(), near) - targets().begin());
}

/// Targets that tables have room for.
std::vector<std::size_t> shown_targets() {
  std::vector<std::size_t> shown;
  for (int exponent = -1; exponent >= -9; --exponent) shown.push_back(power_of_ten(exponent));
  return shown;
}

std::vector<std::string> with_targets(std::string first) {
  std::vector<std::string> header = {std::move(first)};
  for (const std::size_t t : shown_targets()) header.push_back(target_name(targets()[t]));
  return header;
}

std::vector<const RunResult*> runs_of_entry(const Results& results, std::size_t entry) {
  std::vector<const RunResult*> runs;
  for (const RunResult& run : results.runs)
    if (run.entry == entry) runs.push_back(&run);
  return runs;
}

template <class Condition>
double share_of(const std::vector<const RunResult*>& runs, Condition condition) {
  return static_cast<double>(std::ranges::count_if(runs, condition)) / static_cast<double>(runs.size());
}

}  // namespace

std::string whole_number(double x) {
  std::string digits = printed("%.0f", x);
  if (!std::isfinite(x)) return digits;
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string standings_html(const Results& results, const Summary& summary) {
  std::string winners;
  std::vector<std::string> header = {"optimizer"};
  for (std::size_t b = 0; b < summary.budgets.size(); ++b) {
    const std::string at = whole_number(static_cast<double>(summary.budgets[b]));
    header.insert(header.end(), {"rank at " + at, "gap", "wins"});
    const std::size_t winner = summary.order(b).front();
    const Standing& s = summary.standings[b][winner];
    winners += "<li>After " + at + " evaluations: <b>" + escape(results.plan.entries[winner].label) +
               "</b> (mean rank " + printed("%.2f", s.mean_rank) + " of " +
               std::to_string(results.plan.entries.size()) + ", typical gap " + gap_text(s.gap) +
               ", least median gap on " + std::to_string(s.wins) + " of " + std::to_string(results.meshes.size()) +
               ")</li>\n";
  }
  Table table(header);
  for (const std::size_t e : summary.order(last_budget(summary))) {
    std::vector<std::string> row = {entry_name(results, e)};
    for (std::size_t b = 0; b < summary.budgets.size(); ++b) {
      const Standing& s = summary.standings[b][e];
      const bool first = summary.order(b).front() == e;
      row.insert(row.end(),
                 {best(first, printed("%.2f", s.mean_rank)), best(first, gap_text(s.gap)), std::to_string(s.wins)});
    }
    table.row(row);
  }
  return "<ul>\n" + winners + "</ul>\n" + table.text() +
         paragraph(
             "On each mesh optimizers are ranked by the median gap of their runs after so many evaluations (ties "
             "share ranks); rank: the mean over meshes. Gap: the geometric mean over meshes of those medians. Wins: "
             "meshes with no smaller median, ties included.");
}

std::string targets_html(const Results& results, const Summary& summary) {
  Table rates(with_targets("success rate")), times(with_targets("expected evaluations"));
  std::vector<double> least(targets().size(), INFINITY);
  for (const auto& overall : summary.overall)
    for (std::size_t t = 0; t < least.size(); ++t) least[t] = std::min(least[t], overall[t].expected());
  for (const std::size_t e : summary.order(last_budget(summary))) {
    std::vector<std::string> rate = {entry_name(results, e)}, time = rate;
    for (const std::size_t t : shown_targets()) {
      const RunningTime& running = summary.overall[e][t];
      rate.push_back(percent(running.success_rate()));
      time.push_back(best(running.expected() == least[t] && std::isfinite(least[t]), whole_number(running.expected())));
    }
    rates.row(rate);
    times.row(time);
  }
  return rates.text() +
         paragraph(
             "Share of the runs on all meshes whose gap came down to the target within the budget. The gap decides, "
             "whatever an optimizer says of its own convergence.") +
         times.text() +
         paragraph(
             "Expected running time (ERT): evaluations of all runs, successful or not, for each success: the price "
             "of the target if failed runs are repeated.");
}

std::string mesh_targets_html(const Results& results, const Summary& summary) {
  std::string text;
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
    if (!results.meshes[mesh].error.empty()) continue;
    Table table(with_targets("expected evaluations"));
    for (const std::size_t e : summary.order(last_budget(summary))) {
      std::vector<std::string> row = {entry_name(results, e)};
      for (const std::size_t t : shown_targets()) {
        const RunningTime& time = summary.cells[e][mesh].to_target[t];
        row.push_back(time.runs == 0 ? printed("", NAN) : whole_number(time.expected()));
      }
      table.row(row);
    }
    text += "<h3>" + escape(results.meshes[mesh].title) + "</h3>\n" + table.text();
  }
  return text;
}

std::string tests_html(const Results& results, const Summary& summary) {
  const std::size_t entries = results.plan.entries.size();
  std::vector<std::vector<int>> better(entries, std::vector<int>(entries));
  for (const PairTest& t : summary.tests) {
    if (t.corrected >= kSignificance) continue;
    if (t.test.superiority > 0.5) ++better[t.first][t.second];
    else ++better[t.second][t.first];
  }
  const std::vector<std::size_t> order = summary.order(last_budget(summary));
  std::vector<std::string> header = {"better than"};
  for (std::size_t i = 0; i < order.size(); ++i) header.push_back(std::to_string(i + 1));
  Table table(header);
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::vector<std::string> row = {std::to_string(i + 1) + " " + entry_name(results, order[i])};
    for (const std::size_t other : order)
      row.push_back(other == order[i] ? "" : std::to_string(better[order[i]][other]));
    table.row(row);
  }
  double least = 1;
  for (const PairTest& t : summary.tests) least = std::min(least, t.corrected);
  return table.text() +
         paragraph(
             "The number of meshes on which the row's final gaps are smaller than the column's by a two-sided "
             "rank-sum test (Mann and Whitney 1947, corrected for ties) at the level of 5 %, corrected by Holm's "
             "method for all " +
             whole_number(static_cast<double>(summary.tests.size())) + " tests of this comparison." +
             (least >= kSignificance ? " <b>No difference is significant: that may take more runs.</b>" : ""));
}

std::string domains_html(const Results& results, const Summary& summary) {
  std::map<std::string, int> variants;
  for (const Entry& entry : results.plan.entries) ++variants[entry.spec];
  Table table(
      {"optimizer", "domain", "runs", "within 1e-3", "within 1e-6", "evaluations to 1e-3", "to 1e-6", "typical gap"});
  bool any = false;
  const std::size_t coarse = power_of_ten(-3), fine = power_of_ten(-6);
  for (std::size_t e = 0; e < results.plan.entries.size(); ++e) {
    const Entry& entry = results.plan.entries[e];
    if (variants[entry.spec] < 2) continue;
    any = true;
    const auto& overall = summary.overall[e];
    table.row({entry_name(results, e), entry.domain, whole_number(static_cast<double>(overall[coarse].runs)),
               percent(overall[coarse].success_rate()), percent(overall[fine].success_rate()),
               whole_number(overall[coarse].expected()), whole_number(overall[fine].expected()),
               gap_text(summary.standings.back()[e].gap)});
  }
  if (!any) return "";
  return report::html::heading("What a domain costs") + table.text() +
         paragraph(
             "paper: the box [0, 90]<sup>3</sup> degrees (eq. 28), which misses a quarter of all orientations, so "
             "that no search of it can succeed on every instance; covering: [0, 180] x [0, 90]<sup>2</sup>, twice as "
             "large and complete; zone: a cube of Rodrigues vectors that holds each orientation about once.");
}

std::string genetic_html(const Results& results) {
  Table table(
      {"genetic algorithm", "runs", "within 1e-3", "within 1e-6", "up > 1e-3 after gen. 150", "> 1e-4", "> 1e-6"});
  bool any = false;
  for (std::size_t e = 0; e < results.plan.entries.size(); ++e) {
    const auto runs = runs_of_entry(results, e);
    if (runs.empty() || runs.front()->record.at("optimizer") != "ga") continue;
    any = true;
    const auto within = [](double target) {
      return [target](const RunResult* r) { return r->trace.final_gap() <= target; };
    };
    const auto generation_150 = [](const RunResult* r) {
      return 150 * r->record.at("parameters").value("population", 50.0);
    };
    std::vector<const RunResult*> longer = runs;  // those that went on after it
    std::erase_if(longer, [&](const RunResult* r) { return r->evaluations <= generation_150(r); });
    const auto rises = [&](double step) {
      return [&, step](const RunResult* r) {
        return r->trace.gap_after(Cost::kEvaluations, generation_150(r)) - r->trace.final_gap() > step;
      };
    };
    table.row({entry_name(results, e), whole_number(static_cast<double>(runs.size())),
               percent(share_of(runs, within(1e-3))), percent(share_of(runs, within(1e-6))),
               percent(share_of(longer, rises(1e-3))), percent(share_of(longer, rises(1e-4))),
               percent(share_of(longer, rises(1e-6)))});
  }
  if (!any) return "";
  return report::html::heading("The paper's genetic algorithm") + table.text() +
         paragraph(
             "The paper finds R stable after about 150 generations (Fig. 6). The last columns say how many runs "
             "still raised R by more than that much after generation 150.");
}

std::string usage_html(const Results& results, const Summary& summary) {
  Table table({"mean of a run", "evaluations", "values", "cuts", "smooths", "turns", "seconds", "CPU seconds",
               "µs an evaluation"});
  for (const std::size_t e : summary.order(last_budget(summary))) {
    const Usage& u = summary.usage[e];
    table.row({entry_name(results, e), whole_number(u.evaluations), whole_number(u.values), whole_number(u.cuts),
               whole_number(u.smooths), whole_number(u.turns), printed("%.4f", u.seconds),
               printed("%.4f", u.cpu_seconds), printed("%.2f", 1e6 * u.cpu_seconds / u.evaluations)});
  }
  return table.text() +
         paragraph(
             "The budget is in evaluations. One evaluation is the value of P at one rotation; a cut (value and "
             "subgradient) counts " +
             std::to_string(Costs::kPerCut) + ", a smooth value with its gradient " +
             std::to_string(Costs::kPerSmooth) + ", the best turn about an axis " + std::to_string(Costs::kPerTurn) +
             ". Each run had one thread, and shared the machine with the runs beside it.");
}

std::string meshes_html(const Results& results) {
  Table table({"mesh", "faces", "directions", "R certified, from", "to", "width", "evaluations", "seconds", "alpha",
               "beta", "gamma"});
  for (const MeshResult& mesh : results.meshes) {
    if (!mesh.error.empty()) continue;
    const Eigen::Vector3d degrees = euler_from_rotation(mesh.rotation) * (180 / std::numbers::pi);
    table.row({escape(mesh.title), whole_number(static_cast<double>(mesh.faces)),
               whole_number(static_cast<double>(mesh.directions)), printed("%.10f", mesh.lower),
               printed("%.10f", mesh.upper), printed("%.1e", mesh.upper - mesh.lower), whole_number(mesh.evaluations),
               printed("%.3f", mesh.seconds), angle(degrees[0]), angle(degrees[1]), angle(degrees[2])});
  }
  return table.text() + paragraph(
                            "Certified: no rotation of the mesh gives more than the upper bound, and the rotation "
                            "shown gives the lower one. Angles are the paper's (eqs. 35-37) in degrees, of the best "
                            "rotation known, in the mesh's own coordinates.");
}

std::string failures_html(const Results& results) {
  std::string items;
  for (const MeshResult& mesh : results.meshes)
    if (!mesh.error.empty()) items += "<li>" + escape(mesh.name) + ": " + escape(mesh.error) + "</li>\n";
  for (const RunResult& run : results.runs)
    if (run.failed)
      items += "<li>" + escape(results.plan.entries[run.entry].label) + " on " +
               escape(results.meshes[run.mesh].title) + ", run " + std::to_string(run.run + 1) + ": " +
               escape(run.record.at("error").get<std::string>()) + "</li>\n";
  return items.empty() ? paragraph("None.") : "<ul>\n" + items + "</ul>\n";
}

}  // namespace rectilin::laboratory
