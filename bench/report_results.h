// The results of a run of the benchmarks, read from Google Benchmark's JSON.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit.h"

namespace rectilin::bench {

/// One benchmark; of several repetitions the median of each number.
struct Result {
  std::string name;                         ///< without the library's suffixes
  std::map<std::string, std::string> keys;  ///< key:value parts of the name
  double seconds = 0;                       ///< per call: processor or real time, as the name's family counts
  std::map<std::string, double> counters;
};

class Results {
 public:
  /// Throws std::runtime_error if the file does not hold results.
  explicit Results(const std::filesystem::path& file);

  const std::vector<Result>& all() const { return results_; }
  /// Those whose name begins so.
  std::vector<const Result*> family(const std::string& prefix) const;
  const Result* find(const std::string& name) const;
  /// A counter of the benchmark of that name; NaN if either is missing.
  double counter(const std::string& name, const std::string& counter) const;

  /// Time (or a counter) against a key's number, for those names that begin and end so.
  std::vector<Point> series(const std::string& prefix, const std::string& suffix = "",
                            const std::string& counter = "") const;

  const nlohmann::json& context() const { return context_; }

 private:
  std::vector<Result> results_;
  nlohmann::json context_;
};

/// The ratios that say whether the aims are met, under plain names; absent where a benchmark did
/// not run.
nlohmann::ordered_json summary(const Results& results);

/// A table of those ratios that have a target: the ratio, the target, whether it is met.
std::string targets(const nlohmann::ordered_json& summary);

/// Three significant digits.
std::string number(double value);

/// Draws time.svg and roofline.svg, with the data beside them.
void draw_time(const Results& results, const std::filesystem::path& folder);
void draw_roofline(const Results& results, const std::filesystem::path& folder);

}  // namespace rectilin::bench
