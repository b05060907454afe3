// Fig. 7: time of the genetic algorithm against the number of faces, for 50, 100 and 200
// generations; with the plain loop over the faces, the flat kernel, and the tree. On one thread, as
// in the paper.
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>

#include "figures/experiments.h"
#include "rectilin/laboratory/statistics.h"
#include "rectilin/measure/naive_area.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/genetic.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::paper::figures {
namespace {

constexpr std::array kGenerations = {50, 100, 200};
constexpr std::size_t kFittedFrom = 1000;  // faces; below, the algorithm itself takes longer than its objective
constexpr std::array kKinds = {"plain loop", "flat kernel", "tree"};

/// [kind][generations], in seconds of processor time.
using Times = std::array<std::array<double, kGenerations.size()>, kKinds.size()>;

double seconds(const Objective& objective, int generations) {
  GeneticOptions options;
  options.generations = generations;
  return run_optimizer(*make_optimizer(genetic_algorithm(), options), objective, {}).cpu_seconds;
}

/// A tree is built by the run that asks for it first, so its time is in that run's.
Times time(const AreaVectors& vectors) {
  Times times;
  for (std::size_t g = 0; g < kGenerations.size(); ++g) {
    times[0][g] = seconds(NaiveArea(vectors), kGenerations[g]);
    times[1][g] = seconds(ProjectedArea(vectors, "mesh", SumMethod::kFlat), kGenerations[g]);
    times[2][g] = seconds(ProjectedArea(vectors, "mesh", SumMethod::kTree), kGenerations[g]);
  }
  return times;
}

struct Timing {
  int largest = 100'000;

  void bind(Parameters& parameters) {
    parameters.integer("largest", largest, 1000, 30'000'000, "faces of the finest built-in mesh");
  }

  ExperimentResult run(const ExperimentContext& context) const {
    ExperimentResult result;
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const std::map<std::size_t, std::string> chosen = choose(context, result.errors);
    if (chosen.empty()) throw MeshError(result.errors.front());
    std::map<std::size_t, Times> times;
    for (const auto& [size, source] : chosen) {
      if (context.stop.stop_requested()) throw Stopped();
      if (context.on_progress) context.on_progress(times.size(), chosen.size(), source);
      times[size] = time(area_vectors(load_mesh(source).mesh));
      result.data.push_back({{"origin", source}, {"directions", size}, {"seconds", times[size]}});
    }
    report::NamedPlot plot = curves(times, context.meshes.empty());
    const auto& [size, slowest] = *times.rbegin();
    char text[240];
    std::snprintf(text, sizeof text,
                  "200 generations take time like N^%.2f with a plain loop (paper: O(N)), N^%.2f "
                  "with the flat kernel "
                  "and N^%.2f with the tree; %.2g, %.2g and %.2g s for N = %zu",
                  exponent(times, 0, 2), exponent(times, 1, 2), exponent(times, 2, 2), slowest[0][2], slowest[1][2],
                  slowest[2][2], size);
    result.says = text;
    result.plots = {std::move(plot)};
    return result;
  }

 private:
  /// Sources by their number of directions: one smooth surface, finer and finer, or of the meshes
  /// given a few of every size.
  std::map<std::size_t, std::string> choose(const ExperimentContext& context, std::vector<std::string>& errors) const {
    std::map<std::size_t, std::string> chosen;
    if (context.meshes.empty()) {
      for (double faces = 1000; faces <= 1.01 * largest; faces *= std::sqrt(10.0))
        chosen.emplace(std::lround(faces), "shape:blob?faces=" + std::to_string(std::lround(faces)));
      return chosen;
    }
    std::map<int, std::pair<std::size_t, std::string>> of_size;  // by quarters of a power of ten
    for (const std::string& source : context.meshes) {
      try {
        const std::size_t size = area_vectors(load_mesh(source).mesh).size();
        of_size.try_emplace(static_cast<int>(4 * std::log10(static_cast<double>(size))), size, source);
      } catch (const MeshError& e) {
        errors.push_back(e.what());
      }
    }
    for (const auto& [quarter, mesh] : of_size) chosen.insert(mesh);
    return chosen;
  }

  /// Fitted to the meshes whose objective takes most of the time, if there are two of them.
  static double exponent(const std::map<std::size_t, Times>& times, std::size_t kind, std::size_t generations) {
    std::vector<double> sizes, seconds;
    const auto large = times.lower_bound(kFittedFrom);
    for (auto at = std::distance(large, times.end()) < 2 ? times.begin() : large; at != times.end(); ++at) {
      sizes.push_back(static_cast<double>(at->first));
      seconds.push_back(at->second[kind][generations]);
    }
    return laboratory::power_law_exponent(sizes, seconds);
  }

  static report::NamedPlot curves(const std::map<std::size_t, Times>& times, bool refined) {
    std::vector<std::string> columns = {"directions"};
    for (const char* kind : kKinds)
      for (const int generations : kGenerations) columns.push_back(kind + (" " + std::to_string(generations)));
    report::Csv csv(columns);
    for (const auto& [size, of_size] : times) {
      std::vector<report::Csv::Cell> row = {size};
      for (const auto& of_kind : of_size)
        for (const double t : of_kind) row.emplace_back(t);
      csv.row(row);
    }
    report::Panel panel{.title = "",
                        .x = {.label = "faces",
                              .logarithmic = true,
                              .lower = static_cast<double>(times.begin()->first),
                              .upper = static_cast<double>(times.rbegin()->first)},
                        .y = {.label = "seconds of processor time", .logarithmic = true},
                        .bands = {},
                        .curves = {}};
    for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
      for (std::size_t g = 0; g < kGenerations.size(); ++g) {
        char label[64];
        std::snprintf(label, sizeof label, "%s, %d: N^%.2f", kKinds[kind], kGenerations[g], exponent(times, kind, g));
        panel.curves.push_back({.y = static_cast<int>(2 + kGenerations.size() * kind + g),
                                .label = label,
                                .style = {.colour = static_cast<int>(kind), .dash = static_cast<int>(2 - g)}});
      }
    return {"fig7", "Generations and fitted exponents are in the legend. Parallel faces count as one.",
            report::Plot(refined ? "Genetic algorithm, one mesh refined" : "Genetic algorithm, given meshes", csv,
                         {panel})};
  }
};

}  // namespace

Experiment fig7() {
  return make_experiment<Timing>("fig7", "Time of the genetic algorithm against the number of faces",
                                 "meshes, of which it picks some of every size (default: one refined)", "largest=3200");
}

}  // namespace rectilin::paper::figures
