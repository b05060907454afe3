#include "figures/series.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace rectilin::paper::figures {
namespace {

constexpr std::size_t kMostPictures = 8;  // pictures of meshes

report::NamedPlot curve(const Series& series, const MeasuredSeries& measured) {
  std::vector<std::string> columns = {series.axis.label, "R", "lower", "upper", "faces"};
  for (const Sample& other : series.compared) columns.push_back(other.label);
  report::Csv csv(columns);
  for (std::size_t i = 0; i < series.members.size(); ++i) {
    const Measured& m = measured.members[i];
    const bool known = m.error.empty();
    std::vector<report::Csv::Cell> row = {series.members[i].number, known ? m.result.value : NAN,
                                          known ? m.lower() : NAN, known ? m.upper() : NAN, m.result.faces};
    for (const Measured& other : measured.compared) row.push_back(other.error.empty() ? other.result.value : NAN);
    csv.row(row);
  }
  report::Axis x = series.axis;
  if (x.logarithmic) {  // gnuplot's own choice are whole decades
    x.lower = series.members.front().number;
    x.upper = series.members.back().number;
  }
  report::Panel panel{
      .title = "", .x = x, .y = {.label = "R", .logarithmic = series.logarithmic}, .bands = {}, .curves = {}};
  for (std::size_t i = 0; i < series.compared.size(); ++i)
    panel.curves.push_back({.y = 6 + static_cast<int>(i),
                            .label = series.compared[i].label,
                            .style = {.colour = 1 + static_cast<int>(i), .dash = 1}});
  panel.curves.push_back({.y = 2, .label = series.compared.empty() ? "" : "R", .style = {}, .points = true});
  return {series.name, series.caption, report::Plot(series.title, csv, {panel})};
}

/// Marks the first, the last, and some evenly between them to be shown.
void show_some(std::vector<Sample>& samples, std::size_t count) {
  const std::size_t last = samples.size() - 1, steps = std::min(count - 1, last);
  for (std::size_t k = 0; k <= steps; ++k) samples[steps == 0 ? 0 : (k * last + steps / 2) / steps].pictured = Up::kZ;
}

}  // namespace

std::string course_text(const std::vector<Measured>& members) {
  const auto& order = &Measured::value;
  const char* verb = std::ranges::is_sorted(members, std::less(), order)      ? "rises"
                     : std::ranges::is_sorted(members, std::greater(), order) ? "falls"
                                                                              : "goes";
  return std::string(verb) + " from " + four_digits(members.front().result.value) + " to " +
         four_digits(members.back().result.value);
}

MeasuredSeries measure(const Series& series, const ExperimentContext& context) {
  std::vector<Sample> all;
  for (const Series::Member& member : series.members) all.push_back(member.sample);
  show_some(all, kMostPictures - series.compared.size());
  for (const Sample& other : series.compared) all.push_back(other), all.back().pictured = Up::kZ;
  const std::vector<Measured> results = measure_all(all, context);

  MeasuredSeries measured;
  const auto split = results.begin() + static_cast<std::ptrdiff_t>(series.members.size());
  measured.members.assign(results.begin(), split);
  measured.compared.assign(split, results.end());
  measured.result.data = to_json(all, results);
  for (std::size_t i = 0; i < series.members.size(); ++i)
    measured.result.data[i][series.axis.label] = series.members[i].number;
  measured.result.errors = errors(results);
  measured.result.sheets = {sheet(series.name + "-meshes", "The meshes, or some of them, with their R.", all, results)};
  measured.result.plots = {curve(series, measured)};
  return measured;
}

}  // namespace rectilin::paper::figures
