// What a cut, a smooth value and a best turn cost in values of the objective, the unit of every
// budget, on smooth and on CAD-like meshes of several sizes, one thread, and what is declared
// (Costs in evaluator.h). Prints a table in Markdown, which papers/laboratory.md quotes.
//
// Usage: prices [INSTRUCTION_SET]
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/mesh/shapes.h"
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
  int calls = 1;
  const auto stretch = [&] {
    for (int i = 0; i < calls; ++i) call(next++ % kRotations);
  };
  while (Stopwatch(thread_seconds).time(stretch) < kStretch) calls *= 2;
  Stopwatch stopwatch(thread_seconds);
  for (int i = 0; i < kStretches; ++i) stopwatch.time(stretch);
  return stopwatch.median() / calls;
}

struct Prices {
  double value;  ///< seconds
  /// In values: a value in a batch, a cut alone and, in batched values, in a batch, a smooth value,
  /// a turn.
  std::array<double, 5> ratios;
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
  const double smooth = seconds_per_call([&](int i) { objective.smooth(rotations[i], 1e-3); });
  const double turn = seconds_per_call([&](int i) {  // in chains, about one axis after the other
    at = objective.best_turn(i % 10 == 0 ? rotations[i] : at, i % 3).rotation;
  });
  return {one, {batch / kBatch / one, cut(1) / one, cut(kBatch) / batch, smooth / one, turn / one}};
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

void print(const std::array<double, 5>& ratios) {
  for (const double ratio : ratios) std::printf(" %.2f |", ratio);
  std::printf("\n");
}

/// About so many faces.
std::string filleted_cube(double faces) {
  return "filleted-cube?rotate=random&segments=" + std::to_string(std::lround(std::sqrt(faces / 48) - 0.5));
}
std::string blob(double faces) { return "blob?faces=" + std::to_string(std::lround(faces)); }

void table() {
  std::printf(
      "| mesh | faces | directions | one value | value in a batch | cut | cut in a batch | smooth "
      "| turn |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  std::array<GeometricMean, 5> usual;
  for (const double faces : {300.0, 1000.0, 3000.0, 20'000.0, 300'000.0})
    for (const auto make : {blob, filleted_cube}) {
      const std::string spec = make(faces);
      const ProjectedArea objective(area_vectors(make_shape(Spec::parse(spec))));
      const Prices prices = measure(objective);
      std::printf("| %s | %zu | %zu | %.2f us |", spec.substr(0, spec.find('?')).c_str(), objective.vectors().faces,
                  objective.vectors().size(), 1e6 * prices.value);
      print(prices.ratios);
      if (faces < kUsualLeast || faces > kUsualMost) continue;
      for (std::size_t i = 0; i < usual.size(); ++i) usual[i].add(prices.ratios[i]);
    }
  std::printf("| geometric mean, %.0f to %.0f faces | | | |", kUsualLeast, kUsualMost);
  std::array<double, 5> means;
  std::ranges::transform(usual, means.begin(), &GeometricMean::value);
  print(means);
  std::printf("| declared | | | |");
  print({Costs::kPerValue, Costs::kPerCut, Costs::kPerCut, Costs::kPerSmooth, Costs::kPerTurn});
}

}  // namespace
}  // namespace rectilin::bench

int main(int argc, char** argv) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::optional<rectilin::ScopedInstructionSet> target;
  if (argc > 1) target.emplace(argv[1]);
  rectilin::bench::table();
}
