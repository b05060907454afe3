#include "rectilin/laboratory/summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "rectilin/optim/run_record.h"

namespace rectilin::laboratory {
namespace {

constexpr double kNoMean = std::numeric_limits<double>::quiet_NaN();

std::vector<double> final_gaps(const std::vector<const RunResult*>& runs) {
  std::vector<double> gaps;
  for (const RunResult* run : runs) gaps.push_back(run->trace.final_gap());
  return gaps;
}

Cell make_cell(const Results& results, std::size_t entry, std::size_t mesh) {
  Cell cell;
  const auto runs = results.of(mesh, entry);
  const std::vector<double> gaps = final_gaps(runs);
  cell.runs = runs.size();
  cell.failures = static_cast<std::size_t>(std::ranges::count_if(runs, &RunResult::failed));
  cell.low = gap_quantile(gaps, 0.1);
  cell.median = gap_quantile(gaps, 0.5);
  cell.high = gap_quantile(gaps, 0.9);
  for (const double target : targets()) {
    RunningTime& time = cell.to_target.emplace_back();
    if (!decidable(results.meshes[mesh], target)) continue;
    for (const RunResult* run : runs) time.add(run->trace.cost_to(Cost::kEvaluations, target), run->evaluations);
  }
  return cell;
}

std::vector<std::uint64_t> budgets_of(std::uint64_t budget) {
  std::vector<std::uint64_t> budgets;
  for (std::uint64_t b = 100; b < budget && b <= budget / 2; b *= 10) budgets.push_back(b);
  budgets.push_back(budget);
  return budgets;
}

/// Standings of all entries after `budget` evaluations.
std::vector<Standing> standings_at(const Results& results, std::uint64_t budget) {
  const std::size_t entries = results.plan.entries.size();
  std::vector<Standing> standings(entries);
  std::size_t meshes = 0;
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
    std::vector<double> medians;
    for (std::size_t entry = 0; entry < entries; ++entry) {
      std::vector<double> gaps;
      for (const RunResult* run : results.of(mesh, entry))
        gaps.push_back(run->trace.gap_after(Cost::kEvaluations, static_cast<double>(budget)));
      medians.push_back(gap_quantile(gaps, 0.5));
    }
    if (std::ranges::any_of(medians, [](double m) { return std::isnan(m); })) continue;  // not all have run
    ++meshes;
    const std::vector<double> rank = ranks(medians);
    const double least = *std::ranges::min_element(medians);
    for (std::size_t entry = 0; entry < entries; ++entry) {
      standings[entry].mean_rank += rank[entry];
      standings[entry].gap += std::log(medians[entry]);
      standings[entry].wins += medians[entry] == least;
    }
  }
  for (Standing& s : standings) {
    s.mean_rank = meshes > 0 ? s.mean_rank / static_cast<double>(meshes) : kNoMean;
    s.gap = meshes > 0 ? std::exp(s.gap / static_cast<double>(meshes)) : kNoMean;
  }
  return standings;
}

std::vector<PairTest> all_tests(const Results& results) {
  std::vector<PairTest> tests;
  const std::size_t entries = results.plan.entries.size();
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
    std::vector<std::vector<double>> gaps;
    for (std::size_t entry = 0; entry < entries; ++entry) gaps.push_back(final_gaps(results.of(mesh, entry)));
    for (std::size_t i = 0; i < entries; ++i)
      for (std::size_t j = i + 1; j < entries; ++j)
        if (!gaps[i].empty() && !gaps[j].empty()) tests.push_back({mesh, i, j, rank_sum(gaps[i], gaps[j])});
  }
  std::vector<double> p;
  for (const PairTest& t : tests) p.push_back(t.test.p);
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < tests.size(); ++i) tests[i].corrected = corrected[i];
  return tests;
}

std::vector<Usage> usage_of(const Results& results) {
  std::vector<Usage> usage(results.plan.entries.size());
  std::vector<double> runs(usage.size());
  for (const RunResult& run : results.runs) {
    Usage& u = usage[run.entry];
    ++runs[run.entry];
    u.evaluations += run.evaluations;
    u.seconds += run.seconds;
    u.cpu_seconds += run.cpu_seconds;
    u.values += run.record.at("values").get<double>();
    u.cuts += run.record.at("cuts").get<double>();
    u.smooths += run.record.at("smooths").get<double>();
    u.turns += run.record.at("turns").get<double>();
  }
  for (std::size_t i = 0; i < usage.size(); ++i)
    for (double* mean : {&usage[i].evaluations, &usage[i].seconds, &usage[i].cpu_seconds, &usage[i].values,
                         &usage[i].cuts, &usage[i].smooths, &usage[i].turns})
      *mean = runs[i] > 0 ? *mean / runs[i] : kNoMean;
  return usage;
}

Json finite_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json to_json(const std::vector<RunningTime>& times) {
  Json result = Json::array();
  for (std::size_t t = 0; t < times.size(); ++t)
    result.push_back({{"target", targets()[t]},
                      {"success_rate", finite_or_null(times[t].success_rate())},
                      {"expected_running_time", finite_or_null(times[t].expected())}});
  return result;
}

Json to_json(const MeshResult& mesh) {
  if (!mesh.error.empty()) return {{"name", mesh.name}, {"error", mesh.error}};
  return {{"name", mesh.name},   {"faces", mesh.faces}, {"directions", mesh.directions},     {"area", mesh.area},
          {"lower", mesh.lower}, {"upper", mesh.upper}, {"rotation", to_json(mesh.rotation)}};
}

}  // namespace

const std::vector<double>& targets() {
  static const std::vector<double> all = [] {
    std::vector<double> list;
    for (int half = -1; half >= -18; --half) list.push_back(std::pow(10.0, half / 2.0));
    return list;
  }();
  return all;
}

std::string target_name(double target) {
  const double halves = std::round(2 * std::log10(target));
  const bool whole = std::fmod(halves, 2) == 0;
  char text[32];
  std::snprintf(text, sizeof text, whole ? "1e%.0f" : "10^%.1f", halves / 2);
  return text;
}

bool decidable(const MeshResult& mesh, double target) { return mesh.error.empty() && mesh.width() <= target; }

double gap_quantile(const std::vector<double>& gaps, double p) {
  if (gaps.empty()) return kNoMean;
  std::vector<double> logs;
  for (const double gap : gaps) logs.push_back(std::log(gap));
  return std::exp(quantile(std::move(logs), p));
}

std::vector<std::size_t> Summary::order(std::size_t budget) const {
  std::vector<std::size_t> order(usage.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto& standing = standings[budget];
  std::ranges::stable_sort(order, {}, [&](std::size_t e) { return std::pair(standing[e].mean_rank, standing[e].gap); });
  return order;
}

Summary summarise(const Results& results) {
  Summary summary;
  for (std::size_t entry = 0; entry < results.plan.entries.size(); ++entry) {
    auto& row = summary.cells.emplace_back();
    for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) row.push_back(make_cell(results, entry, mesh));
    auto& overall = summary.overall.emplace_back(targets().size());
    for (const Cell& cell : row) {
      for (std::size_t t = 0; t < overall.size(); ++t) {
        overall[t].cost += cell.to_target[t].cost;
        overall[t].successes += cell.to_target[t].successes;
        overall[t].runs += cell.to_target[t].runs;
      }
    }
  }
  summary.budgets = budgets_of(results.plan.budget);
  for (const std::uint64_t budget : summary.budgets) summary.standings.push_back(standings_at(results, budget));
  summary.tests = all_tests(results);
  summary.usage = usage_of(results);
  return summary;
}

Json to_json(const Summary& summary, const Results& results) {
  Json meshes = Json::array(), optimizers = Json::array();
  for (const MeshResult& mesh : results.meshes) meshes.push_back(to_json(mesh));
  for (std::size_t entry = 0; entry < results.plan.entries.size(); ++entry) {
    Json on_meshes = Json::array(), standings = Json::array();
    for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
      const Cell& cell = summary.cells[entry][mesh];
      on_meshes.push_back({{"mesh", results.meshes[mesh].name},
                           {"runs", cell.runs},
                           {"failures", cell.failures},
                           {"median_final_gap", finite_or_null(cell.median)},
                           {"targets", to_json(cell.to_target)}});
    }
    for (std::size_t b = 0; b < summary.budgets.size(); ++b) {
      const Standing& s = summary.standings[b][entry];
      standings.push_back({{"evaluations", summary.budgets[b]},
                           {"mean_rank", finite_or_null(s.mean_rank)},
                           {"gap", finite_or_null(s.gap)},
                           {"wins", s.wins}});
    }
    optimizers.push_back({{"label", results.plan.entries[entry].label},
                          {"standings", standings},
                          {"targets", to_json(summary.overall[entry])},
                          {"meshes", on_meshes}});
  }
  return {{"meshes", meshes}, {"optimizers", optimizers}};
}

}  // namespace rectilin::laboratory
