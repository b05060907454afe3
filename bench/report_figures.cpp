#include <array>
#include <cstdio>

#include "rectilin/report/plot.h"
#include "report_results.h"

namespace rectilin::bench {
namespace {

/// Columns of different lengths side by side: each curve has its own x and y.
class Curves {
 public:
  void add(std::vector<Point> points, const std::string& label, report::LineStyle style, bool faint = false) {
    if (points.empty()) return;
    const int x = 1 + 2 * static_cast<int>(columns_.size());
    curves_.push_back({.x = x, .y = x + 1, .label = label, .style = style, .faint = faint});
    columns_.push_back(std::move(points));
  }

  void draw(const std::string& title, report::Axis x, report::Axis y, const std::filesystem::path& folder,
            const std::string& name) const {
    if (columns_.empty()) return;
    std::vector<std::string> header;
    std::size_t rows = 0;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      header.push_back("x of " + curves_[c].label);
      header.push_back(curves_[c].label);
      rows = std::max(rows, columns_[c].size());
    }
    report::Csv csv(header);
    for (std::size_t row = 0; row < rows; ++row) {
      std::vector<report::Csv::Cell> cells;
      for (const auto& column : columns_) {
        const bool there = row < column.size();
        cells.push_back(there ? report::Csv::Cell(column[row].size) : report::Csv::Cell(""));
        cells.push_back(there ? report::Csv::Cell(column[row].time) : report::Csv::Cell(""));
      }
      csv.row(cells);
    }
    report::Plot(title, csv,
                 {report::Panel{.title = "", .x = std::move(x), .y = std::move(y), .bands = {}, .curves = curves_}})
        .write(folder, name);
    report::draw(folder, name);
  }

 private:
  std::vector<std::vector<Point>> columns_;
  std::vector<report::Panel::Curve> curves_;
};

std::string with_exponent(const std::string& label, std::span<const Point> points, double least) {
  char text[96];
  std::snprintf(text, sizeof text, "%s: N^%.2f", label.c_str(), exponent(points, least));
  return text;
}

std::string best_target(const Results& results) {
  const auto flat = results.family("flat/");
  return flat.empty() ? "" : flat.front()->name.substr(5, flat.front()->name.find('/', 5) - 5);
}

}  // namespace

void draw_time(const Results& results, const std::filesystem::path& folder) {
  Curves curves;
  const auto add = [&](std::vector<Point> points, double calls, const char* label, report::LineStyle style,
                       double least = 0) {
    for (Point& p : points) p.time *= 1e6 / calls;
    if (points.size() > 1) curves.add(points, with_exponent(label, points, least), style);
  };
  const std::string flat = "flat/" + best_target(results);
  add(results.series("naive/"), 1, "naive loop", {.colour = 1});
  add(results.series(flat + "/double/directions:150/", "/threads:1"), 150, "flat double", {.colour = 0});
  add(results.series(flat + "/single/directions:150/", "/threads:1"), 150, "flat single", {.colour = 0, .dash = 1});
  add(results.series("query/values/", "", "seconds_per_direction"), 1, "tree", {.colour = 2}, kTreeFrom);
  add(results.series("query/local_cuts/", "", "seconds_per_direction"), 1, "tree, local cuts", {.colour = 2, .dash = 1},
      kTreeFrom);
  curves.draw("Time of h(u), one core", {.label = "faces", .logarithmic = true},
              {.label = "microseconds a direction", .logarithmic = true}, folder, "time");
}

void draw_roofline(const Results& results, const std::filesystem::path& folder) {
  constexpr double kOperations = 6;  // a pair: two multiply-adds, a minimum, an addition
  const std::string target = best_target(results);
  Curves curves;
  int colour = 0;
  for (const std::string precision : {"double", "single"}) {
    const double peak = kOperations * 1e-9 * results.counter("registers/" + target + "/" + precision, "pairs/s");
    const double bandwidth =
        1e-9 * results.counter("bandwidth/" + precision + "/faces:10000000/threads:1", "peak_bytes/s");
    const double bytes = precision == "double" ? 24 : 12;
    const auto roof = [&](double intensity) { return Point{intensity, std::min(peak, bandwidth * intensity)}; };
    if (peak > 0 && bandwidth > 0)
      curves.add({roof(0.1), roof(peak / bandwidth), roof(1000)}, "roof, " + precision, {.colour = colour, .dash = 1});
    for (const auto& [faces, where, dash] : {std::tuple{"10000000", "memory", 0}, {"10000", "cache", 2}}) {
      std::vector<Point> points;
      for (const char* directions : {"1", "3", "24", "150"}) {
        const double pairs = results.counter(
            "flat/" + target + "/" + precision + "/directions:" + directions + "/faces:" + faces + "/threads:1",
            "pairs/s");
        if (pairs > 0) points.push_back({kOperations * std::stod(directions) / bytes, kOperations * 1e-9 * pairs});
      }
      curves.add(points, precision + " from " + where, {.colour = colour, .dash = dash});
    }
    ++colour;
  }
  curves.draw("Roofline of the flat sum, one core: 1, 3, 24, 150 directions",
              {.label = "operations a byte of area vectors", .logarithmic = true},
              {.label = "billion operations a second", .logarithmic = true}, folder, "roofline");
}

}  // namespace rectilin::bench
