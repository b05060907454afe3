#include "report_results.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rectilin::bench {
namespace {

using nlohmann::json;

/// Fields of the library's own; the other numbers are counters.
bool is_counter(const std::string& key, const json& value) {
  static const std::vector<std::string> own = {"family_index", "per_family_instance_index",
                                               "repetitions",  "repetition_index",
                                               "threads",      "iterations",
                                               "real_time",    "cpu_time"};
  return value.is_number() && std::find(own.begin(), own.end(), key) == own.end();
}

double unit(const std::string& name) { return name == "s" ? 1 : name == "ms" ? 1e-3 : name == "us" ? 1e-6 : 1e-9; }

Result parse(const json& entry) {
  Result result;
  bool real = false;
  std::istringstream path(entry.value("run_name", ""));
  for (std::string part; std::getline(path, part, '/');) {
    if (part == "real_time" || part == "manual_time") {
      real = true;
      continue;
    }
    if (part.starts_with("repeats:") || part.starts_with("iterations:")) continue;
    result.name += (result.name.empty() ? "" : "/") + part;
    if (const auto colon = part.find(':'); colon != std::string::npos)
      result.keys[part.substr(0, colon)] = part.substr(colon + 1);
  }
  result.seconds = entry.value(real ? "real_time" : "cpu_time", 0.0) * unit(entry.value("time_unit", "ns"));
  for (const auto& [key, value] : entry.items())
    if (is_counter(key, value)) result.counters[key] = value;
  return result;
}

/// Medians where there are repetitions, single runs otherwise; no fits of complexity, no failures.
bool wanted(const json& entry) {
  if (entry.value("error_occurred", false)) return false;
  return entry.value("run_type", "") == "iteration" ? entry.value("repetitions", 1) <= 1
                                                    : entry.value("aggregate_name", "") == "median";
}

}  // namespace

Results::Results(const std::filesystem::path& file) {
  std::ifstream in(file);
  const json document = json::parse(in, nullptr, false);
  if (!document.is_object() || !document.contains("benchmarks"))
    throw std::runtime_error(file.string() + ": no results of benchmarks");
  context_ = document.value("context", json::object());
  for (const json& entry : document["benchmarks"])
    if (wanted(entry)) results_.push_back(parse(entry));
}

std::vector<const Result*> Results::family(const std::string& prefix) const {
  std::vector<const Result*> found;
  for (const Result& result : results_)
    if (result.name.starts_with(prefix)) found.push_back(&result);
  return found;
}

const Result* Results::find(const std::string& name) const {
  const auto found = std::find_if(results_.begin(), results_.end(), [&](const Result& r) { return r.name == name; });
  return found == results_.end() ? nullptr : &*found;
}

double Results::counter(const std::string& name, const std::string& counter) const {
  const Result* result = find(name);
  if (result == nullptr || !result->counters.contains(counter)) return NAN;
  return result->counters.at(counter);
}

std::vector<Point> Results::series(const std::string& prefix, const std::string& suffix,
                                   const std::string& counter) const {
  std::vector<Point> points;
  for (const Result* result : family(prefix)) {
    if (!result->name.ends_with(suffix) || !result->keys.contains("faces")) continue;
    const double time = counter.empty() ? result->seconds : this->counter(result->name, counter);
    if (std::isfinite(time)) points.push_back({std::stod(result->keys.at("faces")), time});
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.size < b.size; });
  return points;
}

nlohmann::ordered_json summary(const Results& results) {
  nlohmann::ordered_json out;
  const auto set = [](nlohmann::ordered_json& where, const std::string& key, double value) {
    if (std::isfinite(value)) where[key] = value;
  };
  std::string best;  // the instruction set chosen by itself comes first
  for (const Result* r : results.family("flat/")) {
    if (best.empty()) best = r->name.substr(5, r->name.find('/', 5) - 5);
    if (r->name.ends_with("/directions:150/faces:10000/threads:1")) {
      const std::string kind = r->name.substr(5, r->name.find("/directions") - 5);
      set(out["compute_fraction"], kind, results.counter(r->name, "compute_fraction"));
    }
  }
  for (const Result* r : results.family("bandwidth/"))
    set(out["bandwidth_fraction"], r->name.substr(10), results.counter(r->name, "bandwidth_fraction"));
  const double naive = results.counter("naive/faces:10000", "pairs/s");
  for (const char* precision : {"double", "single"})
    set(out["scalar_speedup"], precision,
        results.counter("flat/" + best + "/" + precision + "/directions:150/faces:10000/threads:1", "pairs/s") / naive);
  for (const Result* r : results.family("speedup/")) {
    const double gained = results.counter(r->name, "speedup");
    set(out["thread_speedup"], r->name.substr(8), gained);
    set(out["thread_speedup_over_registers"], r->name.substr(8),
        gained / results.counter(r->name, "registers_speedup"));
  }
  for (const char* query : {"values", "cuts", "local_cuts", "coarse_cuts"}) {
    const std::string prefix = std::string("query/") + query + "/";
    const std::string name = std::string(query) == "values" ? "tree_speedup" : std::string("tree_speedup_") + query;
    for (const Point& p : results.series(prefix, "", "over_flat"))
      out[name][std::to_string(static_cast<long>(p.size))] = p.time;
    const std::vector<Point> times = results.series(prefix, "", "seconds_per_direction");
    if (times.size() > 1) set(out["tree_exponent"], query, exponent(times, kTreeFrom));
  }
  for (const Point& p : results.series("query/values/", "", "error"))
    out["tree_error"][std::to_string(static_cast<long>(p.size))] = p.time;
  for (const Point& p : results.series("worst/", "", "over_flat"))
    out["worst_case_speedup"][std::to_string(static_cast<long>(p.size))] = p.time;
  const auto flat = results.series("flat/" + best + "/double/directions:150/", "/threads:1");
  if (flat.size() > 1) out["flat_exponent"] = exponent(flat);
  set(out, "tree_bytes_per_face", results.counter("build/faces:1000000/threads:1", "bytes_per_face"));
  set(out, "tree_memory_over_vectors", results.counter("build/faces:1000000/threads:1", "memory_ratio"));
  for (const Result* r : results.family("chain/faces:1000000/")) {
    const std::string with = r->name.substr(r->name.rfind('/') + 1);
    set(out["tree_build_over_flat"], "chain/" + with, results.counter(r->name, "chain_over_flat"));
    set(out["tree_build_over_flat"], "tree/" + with, results.counter(r->name, "tree_over_flat"));
  }
  for (const Result* r : results.family("proof/"))
    set(out["certify_over_ga"], r->name.substr(6), results.counter(r->name, "certify_over_ga"));
  return out;
}

}  // namespace rectilin::bench
