// What exact search costs in large collections: signatures of a database, perturbed until there are enough.
//
//     bench_nearest SHAPES.db [benchmark's options]
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <iostream>
#include <memory>

#include "grown.h"
#include "rectilin/base/random.h"
#include "rectilin/search/diffusion.h"
#include "rectilin/search/nearest.h"

namespace {

using namespace rectilin;
using namespace rectilin::search;
using rectilin::bench::Originals;
using rectilin::bench::perturbed;

/// A collection of so many, kept from one benchmark to the next of the same size.
const NearestSearch& collection(const Originals& originals, std::size_t size) {
  static std::unique_ptr<NearestSearch> kept;
  if (!kept || kept->size() != size) {
    kept.reset();
    kept = std::make_unique<NearestSearch>(originals.descriptor);
    kept->reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
      Random random(i);
      kept->add(perturbed(originals.parts[i % originals.parts.size()], random));
    }
  }
  return *kept;
}

void nearest(benchmark::State& state, const Originals& originals, bool by_diffusion) {
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
  const NearestSearch& search = collection(originals, static_cast<std::size_t>(state.range(0)));
  Random random(99);
  double compared = 0, queries = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const Parts query = perturbed(originals.parts[random.below(originals.parts.size())], random);
    NearestCosts costs;
    state.ResumeTiming();
    if (by_diffusion) {
      benchmark::DoNotOptimize(diffused_nearest(search, query, 20));
    } else {
      benchmark::DoNotOptimize(search.nearest(query, 20, {}, &costs));
    }
    compared += static_cast<double>(costs.compared);
    ++queries;
  }
  if (!by_diffusion) state.counters["compared"] = compared / queries;
}

void compare(benchmark::State& state, const Originals& originals) {
  const NearestSearch& search = collection(originals, originals.parts.size());
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.distance(originals.parts[0], i));
    i = (i + 1) % search.size();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: bench_nearest SHAPES.db [options of Google Benchmark]\n";
    return 2;
  }
  try {
    const Originals originals(argv[1]);
    benchmark::RegisterBenchmark("compare", [&](auto& state) {
      compare(state, originals);
    })->Unit(benchmark::kMicrosecond);
    for (const bool by_diffusion : {false, true})
      benchmark::RegisterBenchmark(by_diffusion ? "nearest_by_diffusion" : "nearest",
                                   [&, by_diffusion](auto& state) { nearest(state, originals, by_diffusion); })
          ->ArgsProduct({{1'000, 10'000, 100'000, 300'000, 1'000'000}, {1, 2}})
          ->ArgNames({"shapes", "threads"})
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    --argc;
    argv[1] = argv[0];
    ++argv;
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
