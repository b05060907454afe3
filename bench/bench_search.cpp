// Whole searches: the paper's genetic algorithm, and the proof of the optimum.
#include <memory>

#include "bench.h"
#include "inputs.h"
#include "rectilin/measure/naive_area.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::bench {
namespace {

using MakeObjective = std::unique_ptr<Objective> (*)(const AreaVectors&);

template <SumMethod kMethod, Precision kPrecision>
std::unique_ptr<Objective> projected_area(const AreaVectors& vectors) {
  return std::make_unique<ProjectedArea>(vectors, "mesh", kMethod, kPrecision);
}

void search(benchmark::State& state, const std::string& optimizer, MakeObjective make, std::size_t faces) {
  std::unique_ptr<Optimizer> search;
  try {
    search = all_optimizers().make(optimizer);
  } catch (const ParameterError&) {
    state.SkipWithError(("there is no optimizer " + optimizer).c_str());
    return;
  }
  const std::unique_ptr<Objective> objective = make(smooth_vectors(faces));
  RunRecord record;
  for (auto _ : state) record = run_optimizer(*search, *objective, {});
  state.counters["evaluations"] = static_cast<double>(record.costs.evaluations());
  state.counters["rectilinearity"] = rectilinearity(record.incumbent.value);
}

}  // namespace

void register_search_benchmarks() {
  const std::pair<const char*, MakeObjective> objectives[] = {
      {"naive", [](const AreaVectors& v) -> std::unique_ptr<Objective> { return std::make_unique<NaiveArea>(v); }},
      {"flat_double", projected_area<SumMethod::kFlat, Precision::kDouble>},
      {"flat_single", projected_area<SumMethod::kFlat, Precision::kSingle>},
      {"tree", projected_area<SumMethod::kTree, Precision::kDouble>},
      {"auto", projected_area<SumMethod::kAuto, Precision::kDouble>}};
  const auto add = [](const std::string& optimizer, const std::string& kind, MakeObjective make, std::size_t faces) {
    benchmark::RegisterBenchmark((optimizer + "/" + kind + pair("faces", faces)).c_str(), search, optimizer, make,
                                 faces)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  for (const std::size_t faces : {20'000u, 1'000'000u})
    for (const auto& [kind, make] : objectives) add("ga", kind, make, faces);
  for (const std::size_t faces : {20'000u, 1'000'000u})
    add("certify", "auto", projected_area<SumMethod::kAuto, Precision::kDouble>, faces);
}

}  // namespace rectilin::bench
