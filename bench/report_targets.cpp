// What the ratios should be.
#include <cstdio>

#include "report_results.h"

namespace rectilin::bench {
namespace {

/// For the ratios of this name whose key contains `part`.
struct Target {
  const char *name, *part;
  enum Sense { kAtLeast, kAtMost } sense;
  double bound;
};

constexpr Target kTargets[] = {
    {"compute_fraction", "", Target::kAtLeast, 0.85},
    {"bandwidth_fraction", "threads:1", Target::kAtLeast, 0.8},
    {"scalar_speedup", "", Target::kAtLeast, 12},
    {"thread_speedup", "directions:15", Target::kAtLeast, 1.8},
    {"thread_speedup_over_registers", "directions:15", Target::kAtLeast, 0.9},
    {"tree_speedup", "1000000", Target::kAtLeast, 5},
    {"tree_speedup", "10000000", Target::kAtLeast, 15},
    {"tree_exponent", "", Target::kAtMost, 0.6},
    {"tree_error", "", Target::kAtMost, 1e-12},
    {"worst_case_speedup", "", Target::kAtLeast, 1 / 1.2},
    {"tree_memory_over_vectors", "", Target::kAtMost, 2.5},
    {"tree_build_over_flat", "tree/", Target::kAtMost, 100},
};

std::string row(const Target& target, const std::string& name, double value) {
  const bool least = target.sense == Target::kAtLeast;
  const bool met = least ? value >= target.bound : value <= target.bound;
  std::string text = "| " + name + " | " + number(value) + " | ";
  text += (least ? "at least " : "at most ") + number(target.bound);
  return text + (met ? " | yes |\n" : " | **no** |\n");
}

}  // namespace

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string targets(const nlohmann::ordered_json& summary) {
  std::string text = "| ratio | measured | target | met |\n| --- | --- | --- | --- |\n";
  for (const Target& target : kTargets) {
    if (!summary.contains(target.name)) continue;
    const auto& ratios = summary[target.name];
    if (ratios.is_number()) text += row(target, target.name, ratios);
    // A part that is a number names a mesh's size: the whole key.
    const bool whole = std::isdigit(static_cast<unsigned char>(*target.part)) != 0;
    for (const auto& [key, value] : ratios.items()) {
      if (!value.is_number() || ratios.is_number()) continue;
      if (whole ? key == target.part : key.find(target.part) != std::string::npos)
        text += row(target, std::string(target.name) + ", " + key, value);
    }
  }
  return text;
}

}  // namespace rectilin::bench
