// The normal tree: what it costs to build, and queries against the flat sum's.
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "bench.h"
#include "inputs.h"
#include "rectilin/measure/direction_tree.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/run_sum.h"
#include "stopwatch.h"

namespace rectilin::bench {
namespace {

constexpr std::size_t kBatch = 150;  // a population of fifty rotations

/// With it a large tree gets its twigs.
double first_value(const DirectionTree& tree) {
  const Vector3 u = Vector3::UnitX();
  double h = 0;
  tree.values({&u, 1}, {&h, 1});
  return h;
}

void twigs(benchmark::State& state, std::size_t faces, int thread_count) {
  const auto limit = threads(thread_count);
  const AreaVectors& vectors = smooth_vectors(faces);
  for (auto _ : state) {
    state.PauseTiming();
    const DirectionTree tree(vectors);
    state.ResumeTiming();
    benchmark::DoNotOptimize(first_value(tree));
  }
}

void build(benchmark::State& state, std::size_t faces, int thread_count) {
  const auto limit = threads(thread_count);
  const AreaVectors& vectors = smooth_vectors(faces);
  for (auto _ : state) benchmark::DoNotOptimize(DirectionTree(vectors).size());
  const DirectionTree tree(vectors);
  first_value(tree);
  const auto size = static_cast<double>(vectors.size());
  state.counters["bytes_per_face"] = static_cast<double>(tree.bytes()) / size;
  state.counters["memory_ratio"] = 1 + static_cast<double>(tree.bytes()) / (24 * size);
}

/// From triangles to the tree; and, timed aside, one rotation by the flat sum.
void chain(benchmark::State& state, std::size_t faces, int thread_count) {
  const auto limit = threads(thread_count);
  const Mesh mesh = smooth_mesh(faces);
  const FlatSum flat(smooth_vectors(faces));
  Directions directions(random_directions(30), 3);
  std::array<double, 3> h;
  const auto clock = thread_count == 1 ? thread_seconds : wall_seconds;
  Stopwatch sorting(clock), building(clock), summing(clock);
  for (auto _ : state) {
    AreaVectors vectors;
    std::optional<DirectionTree> tree;
    sorting.time([&] { vectors = area_vectors(mesh); });
    building.time([&] { tree.emplace(vectors); });
    summing.time([&] { flat.values(directions.next(), h); });
    benchmark::DoNotOptimize(h.data());
  }
  state.counters["chain_over_flat"] = (sorting.median() + building.median()) / summing.median();
  state.counters["tree_over_flat"] = building.median() / summing.median();
}

/// The largest relative error of the first sums, against long double; of those that vanish, relative
/// to a thousandth of the area.
double largest_error(const AreaVectors& vectors, std::span<const Vector3> u, std::span<const double> h) {
  constexpr std::size_t kChecked = 3;
  double largest = 0;
  for (std::size_t k = 0; k < std::min(kChecked, u.size()); ++k) {
    long double sum = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i)
      sum += std::abs(static_cast<long double>(u[k].x()) * vectors.x[i] +
                      static_cast<long double>(u[k].y()) * vectors.y[i] +
                      static_cast<long double>(u[k].z()) * vectors.z[i]);
    const long double size = std::max(sum, 1e-3L * vectors.total);
    largest = std::max(largest, static_cast<double>(std::abs(h[k] - sum) / size));
  }
  return largest;
}

enum class Query { kValues, kCuts };

/// Batches of directions through the tree, and some of them through the flat sum in between: a
/// search asks only the tree, and what the flat sum drives out of the caches is not to count.
/// `coarse` is the tree's resolution.
void query(benchmark::State& state, const AreaVectors& vectors, const std::vector<Vector3>& all, std::size_t batch,
           Query what, double coarse) {
  const auto limit = threads(1);
  const FlatSum flat(vectors);
  const DirectionTree tree(vectors);
  first_value(tree);
  Directions directions(all, batch);
  std::vector<double> h(batch);
  std::vector<Vector3> g(batch);
  Stopwatch walking(thread_seconds), summing(thread_seconds);
  constexpr std::size_t kFlatEvery = 8;
  std::size_t turn = 0;
  for (auto _ : state) {
    const auto u = directions.next();
    if (turn++ % kFlatEvery == 0) summing.time([&] { what == Query::kValues ? flat.values(u, h) : flat.cuts(u, g); });
    state.SetIterationTime(
        walking.time([&] { what == Query::kValues ? tree.values(u, h, coarse) : tree.cuts(u, g, coarse); }));
  }
  const auto asked = static_cast<double>(batch);
  state.counters["seconds_per_direction"] = walking.median() / asked;
  state.counters["flat_seconds_per_direction"] = summing.median() / asked;
  state.counters["over_flat"] = summing.median() / walking.median();
  if (what == Query::kValues && coarse == 0) {
    const auto u = directions.next();
    tree.values(u, h);
    state.counters["error"] = largest_error(vectors, u, h);
  }
  state.SetComplexityN(static_cast<std::int64_t>(vectors.size()));
}

template <class Function>
auto* add(const std::string& path, Function function) {
  return benchmark::RegisterBenchmark(path.c_str(), function)->UseManualTime();
}

void add_queries(std::size_t faces) {
  const auto smooth = [faces](Query what, double coarse, bool local) {
    return [=](benchmark::State& state) {
      const auto u = local ? local_directions(6000, 24, 0.02) : random_directions(6000);
      query(state, smooth_vectors(faces), u, local ? 24 : kBatch, what, coarse);
    };
  };
  const std::string size = pair("faces", faces);
  add("query/values" + size, smooth(Query::kValues, 0, false));
  add("query/cuts" + size, smooth(Query::kCuts, 0, false));
  add("query/local_cuts" + size, smooth(Query::kCuts, 0, true));
  add("query/coarse_cuts" + size, smooth(Query::kCuts, 0.03, false));
}

/// Directions across which all vectors lie, where a tree gains nothing.
void worst(benchmark::State& state, std::size_t faces) {
  query(state, cylinder_vectors(faces), std::vector<Vector3>(kBatch, cylinder_axis()), kBatch, Query::kValues, 0);
}

/// Sums by runs of vectors against those by all vectors, turn by turn, and what it takes to make the runs.
void runs(benchmark::State& state, const AreaVectors& vectors, const std::vector<Vector3>& all, Query what) {
  constexpr std::size_t kRotations = 16;  // a batch of the branch and bound
  const auto limit = threads(1);
  const FlatSum flat(vectors);
  const RunSum sum(vectors);
  Directions directions(all, 3 * kRotations);
  std::vector<double> h(3 * kRotations);
  std::vector<Vector3> g(3 * kRotations);
  Stopwatch by_runs(thread_seconds), summing(thread_seconds), building(thread_seconds);
  for (auto _ : state) {
    const auto u = directions.next();
    summing.time([&] { what == Query::kValues ? flat.values(u, h) : flat.cuts(u, g); });
    building.time([&] { benchmark::DoNotOptimize(RunSum(vectors)); });
    state.SetIterationTime(by_runs.time([&] { what == Query::kValues ? sum.values(u, h) : sum.cuts(u, g); }));
  }
  const auto asked = static_cast<double>(g.size());
  state.counters["seconds_per_direction"] = by_runs.median() / asked;
  state.counters["over_flat"] = summing.median() / by_runs.median();
  state.counters["building_in_flat_directions"] = building.median() / (summing.median() / asked);
}

}  // namespace

void register_tree_benchmarks() {
  for (const std::size_t faces : {300u, 1000u, 3000u, 10'000u, 30'000u}) {
    for (const auto& [name, what] : {std::pair{"values", Query::kValues}, {"cuts", Query::kCuts}}) {
      add(std::string("runs/") + name + pair("faces", faces),
          [=](benchmark::State& state) { runs(state, smooth_vectors(faces), random_directions(6000), what); });
      add(std::string("runs/worst_") + name + pair("faces", faces), [=](benchmark::State& state) {
        runs(state, cylinder_vectors(faces), std::vector<Vector3>(96, cylinder_axis()), what);
      });
    }
  }
  for (const std::size_t faces : {1000u, 10'000u, 30'000u, 100'000u, 300'000u, 1'000'000u, 3'000'000u, 10'000'000u}) {
    add_queries(faces);
    for (const int thread_count : {1, 2}) {
      const std::string size = pair("faces", faces) + pair("threads", static_cast<std::size_t>(thread_count));
      benchmark::RegisterBenchmark(("build" + size).c_str(), build, faces, thread_count)->UseRealTime();
      benchmark::RegisterBenchmark(("twigs" + size).c_str(), twigs, faces, thread_count)->UseRealTime();
      benchmark::RegisterBenchmark(("chain" + size).c_str(), chain, faces, thread_count)->UseRealTime();
    }
  }
  for (const std::size_t faces : {30'000u, 100'000u, 1'000'000u})
    add("worst" + pair("faces", faces), [faces](benchmark::State& state) { worst(state, faces); });
  benchmark::RegisterBenchmark("complexity/tree",
                               [](benchmark::State& state) {
                                 const auto faces = static_cast<std::size_t>(state.range(0));
                                 query(state, smooth_vectors(faces), random_directions(6000), kBatch, Query::kValues,
                                       0);
                               })
      ->RangeMultiplier(10)
      ->Range(10'000, 10'000'000)
      ->UseManualTime()
      ->Complexity([](benchmark::IterationCount n) { return std::sqrt(static_cast<double>(n)); });
}

}  // namespace rectilin::bench
