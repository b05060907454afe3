// The flat sum against the machine's limits: arithmetic in cache, memory beyond it.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <array>
#include <cmath>
#include <functional>

#include "bench.h"
#include "inputs.h"
#include "peak.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/naive_area.h"
#include "stopwatch.h"

namespace rectilin::bench {
namespace {

const char* name(Precision precision) { return precision == Precision::kSingle ? "single" : "double"; }

double face_bytes(Precision precision) { return precision == Precision::kSingle ? 12 : 24; }

void naive(benchmark::State& state, std::size_t faces) {
  const AreaVectors& vectors = smooth_vectors(faces);
  Directions directions(random_directions(64), 1);
  for (auto _ : state) benchmark::DoNotOptimize(naive_value(vectors, directions.next()[0]));
  const double pairs = static_cast<double>(state.iterations()) * static_cast<double>(vectors.size());
  state.counters["pairs/s"] = rate(pairs);
  state.counters["face_rotations/s"] = rate(pairs / 3);
  state.SetComplexityN(static_cast<std::int64_t>(vectors.size()));
}

struct FlatCase {
  std::string target;
  Precision precision;
  std::size_t faces, directions;
  int threads;
};

/// A batch, and the same pairs' arithmetic alone, in turns.
void flat(benchmark::State& state, const FlatCase& which) {
  const auto limit = threads(which.threads);
  const AreaVectors& vectors = smooth_vectors(which.faces);
  const ScopedInstructionSet target(which.target);
  const FlatSum sum(vectors, which.precision);
  const RegisterLoop arithmetic = register_loop(which.target, which.precision);
  const bool compared = arithmetic && which.threads == 1 && which.directions >= 24;
  Directions directions(random_directions(4 * which.directions), which.directions);
  std::vector<double> h(which.directions);
  const auto clock = which.threads == 1 ? thread_seconds : wall_seconds;
  Stopwatch summing(clock), computing(clock);
  constexpr std::size_t kRounds = 4096;
  double computed = 0;
  for (auto _ : state) {
    state.SetIterationTime(summing.time([&] {
      sum.values(directions.next(), h);
      benchmark::DoNotOptimize(h.data());
    }));
    if (compared) computing.time([&] { computed = arithmetic(kRounds); });
  }
  const auto faces = static_cast<double>(vectors.size());
  const double pairs = faces * static_cast<double>(which.directions);
  state.counters["pairs/s"] = pairs / summing.median();
  state.counters["face_rotations/s"] = pairs / 3 / summing.median();
  state.counters["bytes/s"] = faces * face_bytes(which.precision) / summing.median();
  if (compared) state.counters["compute_fraction"] = pairs / computed / summing.over(computing);
  state.SetComplexityN(static_cast<std::int64_t>(vectors.size()));
}

/// Reads the first `size` of each component, a part by each thread.
void read_parts(const AreaVectors& vectors, std::size_t size, std::size_t parts) {
  tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t i) {
    const std::size_t begin = i * size / parts, end = (i + 1) * size / parts;
    benchmark::DoNotOptimize(
        read_arrays(vectors.x.data() + begin, vectors.y.data() + begin, vectors.z.data() + begin, end - begin));
  });
}

/// One rotation, and the bare reading of its vectors, in turns: whatever else the machine does
/// strikes both. The bytes are the same, so the ratio of times is the fraction of the bandwidth.
void bandwidth(benchmark::State& state, std::size_t faces, Precision precision, int thread_count) {
  const auto limit = threads(thread_count);
  const AreaVectors& vectors = smooth_vectors(faces);
  const FlatSum sum(vectors, precision);
  // Single precision reads half the bytes: half of each array.
  const std::size_t doubles = precision == Precision::kSingle ? vectors.size() / 2 : vectors.size();
  Directions directions(random_directions(30), 3);
  std::array<double, 3> h;
  const auto clock = thread_count == 1 ? thread_seconds : wall_seconds;
  Stopwatch reading(clock), summing(clock);
  const auto parts = static_cast<std::size_t>(thread_count);
  for (auto _ : state) {
    reading.time([&] { read_parts(vectors, doubles, parts); });
    state.SetIterationTime(summing.time([&] {
      sum.values(directions.next(), h);
      benchmark::DoNotOptimize(h.data());
    }));
  }
  const double bytes = face_bytes(precision) * static_cast<double>(vectors.size());
  state.counters["bytes/s"] = bytes / summing.median();
  state.counters["peak_bytes/s"] = bytes / reading.median();
  state.counters["bandwidth_fraction"] = reading.over(summing);
}

/// Work done by one thread and by two, in turns.
class ThreadTurns {
 public:
  using Work = std::function<void(std::size_t threads)>;

  explicit ThreadTurns(Work work) : work_(std::move(work)) {
    const double once = Stopwatch(wall_seconds).time([&] { arenas_[0].execute([&] { work_(1); }); });
    calls_ = static_cast<int>(std::ceil(kTurnSeconds / once));
  }

  void take() {
    for (const std::size_t i : {0, 1}) {
      watches_[i].time([&] {
        arenas_[i].execute([&] {
          for (int call = 0; call < calls_; ++call) work_(i + 1);
        });
      });
    }
  }

  double speedup() const { return watches_[0].over(watches_[1]); }

 private:
  static constexpr double kTurnSeconds = 5e-3;  // that waking the second thread does not count

  Work work_;
  std::array<tbb::task_arena, 2> arenas_ = {tbb::task_arena(1), tbb::task_arena(2)};
  std::array<Stopwatch, 2> watches_ = {Stopwatch(wall_seconds), Stopwatch(wall_seconds)};
  int calls_;
};

/// Beside arithmetic alone, which tells what the machine grants a second thread at that moment.
void speedup(benchmark::State& state, RegisterLoop arithmetic, const ThreadTurns::Work& work) {
  constexpr std::size_t kParts = 64, kRounds = 4096;
  ThreadTurns turns(work);
  ThreadTurns computing(
      [&](std::size_t) { tbb::parallel_for(std::size_t{0}, kParts, [&](std::size_t) { arithmetic(kRounds); }); });
  for (auto _ : state) {
    turns.take();
    computing.take();
  }
  state.counters["speedup"] = turns.speedup();
  state.counters["registers_speedup"] = computing.speedup();
}

void flat_speedup(benchmark::State& state, RegisterLoop arithmetic, std::size_t faces, std::size_t count) {
  const FlatSum sum(smooth_vectors(faces));
  Directions directions(random_directions(4 * count), count);
  std::vector<double> h(count);
  speedup(state, arithmetic, [&](std::size_t) { sum.values(directions.next(), h); });
}

/// What two threads can gain where memory counts.
void reading_speedup(benchmark::State& state, RegisterLoop arithmetic, std::size_t faces) {
  const AreaVectors& vectors = smooth_vectors(faces);
  speedup(state, arithmetic, [&](std::size_t parts) { read_parts(vectors, vectors.size(), parts); });
}

void registers(benchmark::State& state, RegisterLoop loop) {
  double pairs = 0;
  for (auto _ : state) pairs += loop(4096);
  state.counters["pairs/s"] = rate(pairs);
}

void add_flat(const FlatCase& which) {
  const std::string path = "flat/" + which.target + "/" + name(which.precision) + pair("directions", which.directions) +
                           pair("faces", which.faces) + pair("threads", static_cast<std::size_t>(which.threads));
  benchmark::RegisterBenchmark(path.c_str(), flat, which)->UseManualTime();
}

}  // namespace

void register_kernel_benchmarks() {
  const std::vector<std::string> targets = instruction_sets();
  constexpr std::array<Precision, 2> kPrecisions = {Precision::kDouble, Precision::kSingle};
  for (const std::string& target : targets)
    for (const Precision precision : kPrecisions)
      if (const RegisterLoop loop = register_loop(target, precision))
        benchmark::RegisterBenchmark(("registers/" + target + "/" + name(precision)).c_str(), registers, loop);

  for (const std::size_t faces : {1000u, 10'000u, 100'000u, 1'000'000u, 10'000'000u}) {
    benchmark::RegisterBenchmark(("naive" + pair("faces", faces)).c_str(), naive, faces);
    for (const std::string& target : targets)
      for (const Precision precision : kPrecisions)
        for (const std::size_t directions : {1u, 3u, 24u, 150u})
          for (const int thread_count : {1, 2}) add_flat({target, precision, faces, directions, thread_count});
    for (const Precision precision : kPrecisions)
      for (const int thread_count : {1, 2})
        benchmark::RegisterBenchmark((std::string("bandwidth/") + name(precision) + pair("faces", faces) +
                                      pair("threads", static_cast<std::size_t>(thread_count)))
                                         .c_str(),
                                     bandwidth, faces, precision, thread_count)
            ->UseManualTime();
  }

  const std::string best = targets.front();
  if (const RegisterLoop loop = register_loop(best, Precision::kDouble)) {
    const auto add = [](const std::string& path, auto... work) {
      benchmark::RegisterBenchmark(("speedup" + path).c_str(), work...)->UseRealTime();
    };
    add("/reading/faces:10000000", reading_speedup, loop, 10'000'000);
    for (const auto& [faces, directions] :
         {std::pair{10'000u, 1500u}, {100'000u, 150u}, {1'000'000u, 150u}, {10'000'000u, 150u}, {10'000'000u, 3u}})
      add(pair("directions", directions) + pair("faces", faces), flat_speedup, loop, faces, directions);
  }

  // The claim that the flat sum's time grows like N, at one number of directions.
  benchmark::RegisterBenchmark(
      "complexity/flat",
      [best](benchmark::State& state) {
        flat(state, {best, Precision::kDouble, static_cast<std::size_t>(state.range(0)), 150, 1});
      })
      ->RangeMultiplier(10)
      ->Range(1000, 10'000'000)
      ->UseManualTime()
      ->Complexity(benchmark::oN);
}

}  // namespace rectilin::bench
