#include "claims/search_cost.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "rectilin/mesh/source.h"
#include "rectilin/optim/genetic.h"
#include "rectilin/optim/run_record.h"

namespace rectilin::paper::claims {
namespace {

constexpr double kStable = 1e-3;
constexpr int kStableGeneration = 150;

Finding stable_finding(const Objective& objective, std::string where, Random& random) {
  const LateGain gain = gain_after_150(objective, random.bits());
  return {kStable - gain.r, std::move(where), nullptr, gain.rotation, "gain " + std::to_string(gain.r)};
}

double thread_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Processor seconds of this thread for one face at one rotation: the least of some tries, since a
/// busy machine can only add.
double seconds_per_face(const ProjectedArea& objective, Random random) {
  std::array<Rotation, 8> rotations;
  for (Rotation& rotation : rotations) rotation = random_rotation(random);
  std::array<double, 8> values{};
  double least = 1e300;
  tbb::task_arena(1).execute([&] {
    for (int i = 0; i < 9; ++i) {
      const double before = thread_seconds();
      objective.values(rotations, values);
      least = std::min(least, thread_seconds() - before);
    }
  });
  return least / static_cast<double>(rotations.size() * objective.vectors().faces);
}

}  // namespace

LateGain gain_after_150(const Objective& objective, std::uint64_t seed) {
  const RunRecord run =
      run_optimizer(*make_optimizer(genetic_algorithm()), objective, {.seed = seed, .domain = &paper_domain()});
  const auto evaluations = static_cast<std::uint64_t>(kStableGeneration * GeneticOptions().population);
  double then = run.trace.front().value;
  for (const TracePoint& point : run.trace)
    if (point.evaluations <= evaluations) then = point.value;
  return {objective.merit(run.incumbent.value) - objective.merit(then), run.incumbent.rotation};
}

Finding check_stable(const TestMesh& tested, Random random) {
  return stable_finding(*tested.objective, tested.source, random);
}

std::vector<Finding> check_stable_on_shapes(Random random) {
  std::vector<Finding> findings;
  for (const char* shape : {"pyramid", "prism", "cut-cube", "filleted-cube?segments=3", "torus", "blob?faces=2000"})
    for (int i = 0; i < 5; ++i) {
      const std::string source = posed(shape, random);
      findings.push_back(stable_finding(ProjectedArea(area_vectors(load_mesh(source).mesh)), source, random));
    }
  return findings;
}

std::vector<Finding> check_always_stable(Random random) {
  const std::string source = "shape:pyramid?rotate=random&seed=1";
  const ProjectedArea objective(area_vectors(load_mesh(source).mesh));
  std::vector<Finding> findings;
  for (int i = 0; i < 50; ++i) findings.push_back(stable_finding(objective, source, random));
  return findings;
}

std::vector<Finding> check_linear_cost(Random random) {
  constexpr double kSlack = 8;
  std::array<double, 2> seconds{};
  std::array<std::uint64_t, 2> evaluations{};
  const std::array<std::string, 2> sources{"shape:blob?faces=2000", "shape:blob?faces=128000"};
  for (std::size_t i = 0; i < 2; ++i) {
    const ProjectedArea objective(area_vectors(load_mesh(sources[i]).mesh), sources[i], SumMethod::kFlat);
    seconds[i] = seconds_per_face(objective, random);
    GeneticOptions few;
    few.generations = 10;
    evaluations[i] = run_optimizer(*make_optimizer(genetic_algorithm(), few), objective, {}).costs.evaluations();
  }
  const double growth = seconds[1] / seconds[0];
  Finding finding{kSlack - growth, sources[1], nullptr, {}, "time per face times " + std::to_string(growth)};
  if (evaluations[0] != evaluations[1]) finding.margin = -1, finding.note = "the evaluations depend on the mesh";
  return {finding};
}

}  // namespace rectilin::paper::claims
