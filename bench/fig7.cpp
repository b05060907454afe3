// The paper's Fig. 7 again: time of the genetic algorithm against the number of faces, for 50, 100
// and 200 generations, for the naive loop, the flat kernel and the tree. One thread, as in the
// paper. Usage: fig7 FOLDER [LARGEST]    writes fig7.csv, .gp, .svg and fig7.json to the folder;
// with RECTILIN_DATA set, also fig7-data.* for real meshes.
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>

#include "fit.h"
#include "inputs.h"
#include "naive.h"
#include "rectilin/experiments/figure.h"
#include "rectilin/measure/mesh_io.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/source.h"
#include "rectilin/optim/genetic.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::array<int, 3> kGenerations = {50, 100, 200};
constexpr std::array<const char*, 3> kKinds = {"naive loop", "flat kernel", "tree"};

/// Processor time of one run. The tree is built in the run that asks for it first, so its time is
/// in it.
double seconds(const Objective& objective, int generations) {
  GeneticOptions options;
  options.generations = generations;
  return run_optimizer(GeneticAlgorithm(options), objective, {}).cpu_seconds;
}

/// [kind][generations] for one mesh.
using Times = std::array<std::array<double, 3>, 3>;

Times measure(const AreaVectors& vectors) {
  Times times;
  for (std::size_t g = 0; g < kGenerations.size(); ++g) {
    times[0][g] = seconds(NaiveArea(vectors), kGenerations[g]);
    times[1][g] = seconds(ProjectedArea(vectors, "mesh", Evaluation::kFlat), kGenerations[g]);
    times[2][g] = seconds(ProjectedArea(vectors, "mesh", Evaluation::kTree), kGenerations[g]);
  }
  return times;
}

/// The curves of one set of meshes: writes and draws them, and returns their fitted exponents.
Json plot(const std::map<std::size_t, Times>& results, const std::string& title,
          const fs::path& folder, const std::string& name) {
  Csv csv({"faces", "naive50", "naive100", "naive200", "flat50", "flat100", "flat200", "tree50",
           "tree100", "tree200"});
  for (const auto& [faces, times] : results) {
    std::vector<Csv::Cell> cells{faces};
    for (const auto& kind : times)
      for (const double time : kind) cells.emplace_back(time);
    csv.row(cells);
  }
  Panel panel{.title = "",
              .x = {.label = "faces", .logarithmic = true},
              .y = {.label = "seconds of processor time", .logarithmic = true},
              .bands = {},
              .curves = {}};
  Json exponents;
  for (int kind = 0; kind < 3; ++kind)
    for (int g = 0; g < 3; ++g) {
      std::vector<Point> points;
      for (const auto& [faces, times] : results)
        points.push_back({static_cast<double>(faces), times[kind][g]});
      const double slope = exponent(points);
      exponents[kKinds[kind]][std::to_string(kGenerations[g])] = slope;
      char label[64];
      std::snprintf(label, sizeof label, "%s, %d: N^%.2f", kKinds[kind], kGenerations[g], slope);
      panel.curves.push_back({.x = 1,
                              .y = 2 + 3 * kind + g,
                              .label = label,
                              .style = {.colour = kind, .dash = 2 - g}});
    }
  Figure(title, csv, {panel}).write(folder, name);
  draw(folder, name);
  return exponents;
}

/// Distinct sizes from about a thousand faces up, a few of each decade.
std::map<std::size_t, Times> real_meshes(const fs::path& data) {
  std::map<int, std::string> chosen;  // by size of file, in quarters of a power of ten
  for (const std::string& file : expand_folders({data.string()})) {
    const int size = static_cast<int>(4 * std::log10(static_cast<double>(fs::file_size(file))));
    if (size >= 16) chosen.try_emplace(size, file);
  }
  std::map<std::size_t, Times> results;
  for (const auto& [size, file] : chosen) {
    try {
      const LoadedMesh loaded = read_mesh(file);
      const AreaVectors vectors = area_vectors(loaded.mesh);
      results[vectors.size()] = measure(vectors);
      std::cout << file << ": " << vectors.size() << " directions\n" << std::flush;
    } catch (const MeshError& e) {
      std::cerr << e.what() << '\n';
    }
  }
  return results;
}

void run(const fs::path& folder, std::size_t largest) {
  fs::create_directories(folder);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  std::map<std::size_t, Times> refined;
  for (std::size_t faces = 1000; faces <= largest; faces *= 10)
    for (const std::size_t size : {faces, 3 * faces})
      if (size <= largest) {
        const AreaVectors& vectors = smooth_vectors(size);
        refined[vectors.size()] = measure(vectors);
        std::cout << size << " faces: " << refined[vectors.size()][0][2]
                  << " s with the naive loop\n"
                  << std::flush;
      }
  Json exponents;
  exponents["refined"] = plot(refined, "Genetic algorithm, one mesh refined", folder, "fig7");
  if (const char* data = std::getenv("RECTILIN_DATA"))
    exponents["data"] = plot(real_meshes(fs::path(data) / "psb"), "Genetic algorithm, real meshes",
                             folder, "fig7-data");
  write_text(folder / "fig7.json", exponents.dump(2) + "\n");
}

}  // namespace
}  // namespace rectilin::bench

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: fig7 FOLDER [LARGEST]\n";
    return 2;
  }
  try {
    rectilin::bench::run(argv[1], argc > 2 ? std::stoul(argv[2]) : 1'000'000);
  } catch (const std::exception& e) {
    std::cerr << "fig7: " << e.what() << '\n';
    return 1;
  }
}
