// Turns results of the benchmarks into summary.json, targets.md, table.md, time.svg and
// roofline.svg. Usage: bench_report RESULTS.json FOLDER [EARLIER.json]    with earlier results also
// compare.md
#include <cmath>
#include <cstdio>
#include <iostream>

#include "rectilin/base/whole_file.h"
#include "rectilin/report/csv.h"
#include "rectilin/report/plot.h"
#include "report_results.h"

namespace rectilin::bench {
namespace {

std::string duration(double seconds) {
  const double size = std::abs(seconds);
  if (size < 1e-6) return number(seconds * 1e9) + " ns";
  if (size < 1e-3) return number(seconds * 1e6) + " us";
  return size < 1 ? number(seconds * 1e3) + " ms" : number(seconds) + " s";
}

/// Rates in billions: 2.7e10 pairs/s becomes "27 Gpairs/s".
std::string counter(const std::string& name, double value) {
  if (name.ends_with("/s")) return number(value * 1e-9) + " G" + name;
  if (name.ends_with("seconds_per_direction")) return name + " " + duration(value);
  return name + " " + number(value);
}

std::string table(const Results& results) {
  std::string text = "| benchmark | time | |\n| --- | --- | --- |\n";
  for (const Result& result : results.all()) {
    text += "| `" + result.name + "` | " + duration(result.seconds) + " | ";
    const char* separator = "";
    for (const auto& [name, value] : result.counters) {
      text += separator + counter(name, value);
      separator = ", ";
    }
    text += " |\n";
  }
  return text;
}

/// Time now over time then; below one is faster.
std::string comparison(const Results& now, const Results& then) {
  std::string text = "| benchmark | then | now | ratio |\n| --- | --- | --- | --- |\n";
  for (const Result& result : now.all())
    if (const Result* old = then.find(result.name); old != nullptr && old->seconds > 0)
      text += "| `" + result.name + "` | " + duration(old->seconds) + " | " + duration(result.seconds) + " | " +
              number(result.seconds / old->seconds) + " |\n";
  return text;
}

void report(const std::filesystem::path& file, const std::filesystem::path& folder, const char* earlier) {
  const Results results(file);
  std::filesystem::create_directories(folder);
  const std::string ratios = summary(results).dump(2) + "\n";
  write_whole_file(folder / "summary.json", ratios);
  write_whole_file(folder / "table.md", table(results));
  const std::string aims = targets(summary(results));
  write_whole_file(folder / "targets.md", aims);
  std::cout << ratios << aims;
  if (earlier != nullptr) {
    const std::string text = comparison(results, Results(earlier));
    write_whole_file(folder / "compare.md", text);
    std::cout << text;
  }
  draw_time(results, folder);
  draw_roofline(results, folder);
}

}  // namespace
}  // namespace rectilin::bench

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: bench_report RESULTS.json FOLDER [EARLIER.json]\n";
    return 2;
  }
  try {
    rectilin::bench::report(argv[1], argv[2], argc > 3 ? argv[3] : nullptr);
  } catch (const std::exception& e) {
    std::cerr << "bench_report: " << e.what() << '\n';
    return 1;
  }
}
