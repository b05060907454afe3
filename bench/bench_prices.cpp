// What a cut, a smooth value and a best turn cost in values of the objective, the unit of every budget, on smooth and on
// CAD-like meshes of several sizes, one thread, and what is declared (Costs in evaluator.h).
// Usage: prices [INSTRUCTION_SET]    prints a table in Markdown; papers/laboratory.md quotes it.
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/shapes.h"
#include "rectilin/optim/evaluator.h"
#include "stopwatch.h"

namespace rectilin::bench {
namespace {

constexpr std::size_t kBatch = 50;  // a population
constexpr int kRotations = 1000;
/// Four of five models of the Princeton Shape Benchmark are between these.
constexpr double kUsualLeast = 300, kUsualMost = 20'000;

/// Of one call, in the median over stretches of calls long enough for the clock.
template <class Call>
double seconds_per_call(const Call& call) {
  constexpr double kStretch = 2e-4;
  constexpr int kStretches = 25;
  int next = 0;
  const auto time = [&](int calls) {
    const double start = thread_seconds();
    for (int i = 0; i < calls; ++i) call(next++ % kRotations);
    return thread_seconds() - start;
  };
  int calls = 1;
  while (time(calls) < kStretch) calls *= 2;
  Stopwatch stopwatch(thread_seconds);
  for (int i = 0; i < kStretches; ++i)
    stopwatch.time([&] {
      for (int c = 0; c < calls; ++c) call(next++ % kRotations);
    });
  return stopwatch.median() / calls;
}

struct Prices {
  double value;  ///< seconds
  double batched_value, cut, batched_cut, smooth, turn;  ///< in values; the batched cut in batched values
};

Prices measure(const ProjectedArea& objective) {
  Random random(1);
  std::vector<Rotation> rotations(kRotations + kBatch);
  for (Rotation& r : rotations) r = random_rotation(random);
  std::array<double, kBatch> values;
  std::array<Cut, kBatch> cuts;
  const auto value = [&](std::size_t count) {
    return seconds_per_call([&](int i) { objective.values({&rotations[i], count}, {values.data(), count}); });
  };
  const auto cut = [&](std::size_t count) {
    return seconds_per_call([&](int i) { objective.cuts({&rotations[i], count}, {cuts.data(), count}); });
  };
  Rotation at;
  const double one = value(1), batch = value(kBatch);
  return {one,
          batch / kBatch / one,
          cut(1) / one,
          cut(kBatch) / batch,
          seconds_per_call([&](int i) { objective.smooth(rotations[i], 1e-3); }) / one,
          // Turns come in chains, about one axis after the other.
          seconds_per_call([&](int i) { at = objective.best_turn(i % 10 == 0 ? rotations[i] : at, i % 3).rotation; }) / one};
}

/// Mean of logarithms.
class GeometricMean {
 public:
  void add(double x) { sum_ += std::log(x), ++count_; }
  double value() const { return std::exp(sum_ / count_); }

 private:
  double sum_ = 0;
  int count_ = 0;
};

void row(const std::string& name, double faces, const std::string& directions, const std::string& value,
         const std::array<double, 5>& ratios) {
  std::printf("| %s | %.0f | %s | %s |", name.c_str(), faces, directions.c_str(), value.c_str());
  for (const double ratio : ratios) std::printf(" %.2f |", ratio);
  std::printf("\n");
}

std::string microseconds(double seconds) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2f us", 1e6 * seconds);
  return text.data();
}

/// About so many faces.
std::string filleted_cube(double faces) {
  return "filleted-cube?rotate=random&segments=" + std::to_string(std::lround(std::sqrt(faces / 48) - 0.5));
}
std::string blob(double faces) { return "blob?faces=" + std::to_string(std::lround(faces)); }

void table() {
  std::printf("| mesh | faces | directions | one value | value in a batch | cut | cut in a batch | smooth | turn |\n"
              "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::array<GeometricMean, 5> usual;
  for (const double faces : {300.0, 1000.0, 3000.0, 20'000.0, 300'000.0})
    for (const auto make : {blob, filleted_cube}) {
      const std::string spec = make(faces);
      const ProjectedArea objective(area_vectors(make_shape(Spec::parse(spec))));
      const Prices p = measure(objective);
      const std::array<double, 5> ratios = {p.batched_value, p.cut, p.batched_cut, p.smooth, p.turn};
      row(spec.substr(0, spec.find('?')), static_cast<double>(objective.vectors().faces),
          std::to_string(objective.vectors().size()), microseconds(p.value), ratios);
      if (faces < kUsualLeast || faces > kUsualMost) continue;
      for (std::size_t i = 0; i < ratios.size(); ++i) usual[i].add(ratios[i]);
    }
  std::printf("| geometric mean, %.0f to %.0f faces | | | |", kUsualLeast, kUsualMost);
  for (const GeometricMean& mean : usual) std::printf(" %.2f |", mean.value());
  std::printf("\n| declared | | | | %d | %d | %d | %d | %d |\n", int{Costs::kPerValue}, int{Costs::kPerCut},
              int{Costs::kPerCut}, int{Costs::kPerSmooth}, int{Costs::kPerTurn});
}

}  // namespace
}  // namespace rectilin::bench

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::optional<rectilin::ScopedFlatSumTarget> target;
  if (argc > 1) target.emplace(argv[1]);
  rectilin::bench::table();
}
