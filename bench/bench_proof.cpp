// What a proof of the optimum costs in units of the paper's guess: certify, to a gap of 1e-6, over its genetic
// algorithm, 10,000 evaluations on the fastest flat sum. Both on one thread, in turns, on the same meshes.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "bench.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/registry.h"
#include "rectilin/optim/run_record.h"
#include "stopwatch.h"

namespace rectilin::bench {
namespace {

void proof_and_guess(benchmark::State& state, const std::vector<std::string>& meshes) {
  const auto limit = threads(1);
  const auto certify = builtin_optimizers().make("certify"), ga = builtin_optimizers().make("ga");
  double proof = 0, guess = 0, widest_gap = 0, worst_error = 0, cuts = 0;
  for (auto _ : state) {
    for (const std::string& mesh : meshes) {
      const AreaVectors vectors = area_vectors(load_mesh(mesh).mesh);
      const ProjectedArea fastest(vectors, mesh), flat(vectors, mesh, SumMethod::kFlat, Precision::kSingle);
      const RunRecord proved = run_optimizer(*certify, fastest, {}), guessed = run_optimizer(*ga, flat, {});
      proof += proved.seconds;
      guess += guessed.seconds;
      widest_gap = std::max(widest_gap, rectilinearity(*proved.value_bound) - proved.merit);
      worst_error = std::max(worst_error, proved.merit - guessed.merit);
      cuts += static_cast<double>(proved.costs.cuts);
    }
  }
  state.counters["certify_over_ga"] = proof / guess;
  state.counters["certify_seconds"] = proof;
  state.counters["ga_seconds"] = guess;
  state.counters["widest_gap"] = widest_gap;
  state.counters["worst_ga_error"] = worst_error;
  state.counters["cuts"] = cuts;
}

/// Seconds of processor time that a group of files took, step by step.
struct Steps {
  std::string name;
  std::size_t most;  // faces
  double reading = 0, merging = 0, proving = 0, slowest = 0;

  void count(const std::string& prefix, benchmark::UserCounters& counters) const {
    counters[prefix + "reading_seconds"] = reading;
    counters[prefix + "merging_seconds"] = merging;
    counters[prefix + "proving_seconds"] = proving;
    counters[prefix + "slowest_seconds"] = slowest;
    counters[prefix + "proof_over_reading"] = (merging + proving) / reading;
  }
};

/// From files to proofs, step by step, in processor time of the one thread that does it all.
void files_to_proofs(benchmark::State& state, const std::vector<std::string>& files) {
  const auto limit = threads(1);
  const auto certify = builtin_optimizers().make("certify");
  constexpr std::size_t kAny = std::numeric_limits<std::size_t>::max();
  std::array<Steps, 4> groups = {{{"small_", 999}, {"medium_", 10'000}, {"large_", kAny}, {"", kAny}}};
  double bytes = 0;
  for (auto _ : state) {
    for (const std::string& file : files) {
      const double start = thread_seconds();
      const LoadedMesh loaded = load_mesh(file);
      const double read = thread_seconds();
      AreaVectors vectors = area_vectors(loaded.mesh);
      const double merged = thread_seconds();
      const ProjectedArea objective(std::move(vectors), file);
      run_optimizer(*certify, objective, {});
      const double proved = thread_seconds();
      const std::size_t faces = loaded.mesh.triangles.size();
      Steps& group = *std::ranges::find_if(groups, [faces](const Steps& s) { return faces <= s.most; });
      for (Steps* steps : {&group, &groups.back()}) {
        steps->reading += read - start;
        steps->merging += merged - read;
        steps->proving += proved - merged;
        steps->slowest = std::max(steps->slowest, proved - read);
      }
      bytes += static_cast<double>(std::filesystem::file_size(file));
    }
  }
  for (const Steps& steps : groups) steps.count(steps.name, state.counters);
  state.counters["read_bytes_per_second"] = bytes / groups.back().reading;
}

void add(const std::string& name, const std::vector<std::string>& meshes) {
  benchmark::RegisterBenchmark(("proof/" + name).c_str(), proof_and_guess, meshes)
      ->Iterations(1)
      ->Repetitions(1)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_proof_benchmarks() {
  add("blob/faces:1000000", {"shape:blob?faces=1000000"});
  add("ellipsoid/faces:1000000", {"shape:ellipsoid?faces=1000000"});
  add("noisy_box/faces:1000000", {"shape:box?faces=1000000&noise=0.0002"});
  const char* data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) return;
  const std::filesystem::path models = std::filesystem::path(data) / "psb" / "off";
  if (!std::filesystem::is_directory(models)) return;
  const std::vector<std::string> files = expand_folders({models.string()});
  add("psb", files);
  benchmark::RegisterBenchmark("files_to_proofs/psb", files_to_proofs, files)
      ->Iterations(1)
      ->Repetitions(3)
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace rectilin::bench
