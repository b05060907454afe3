// Time of the pose methods, on one thread, and of the mirror defect beside the loop it replaces.
#include "bench.h"
#include "inputs.h"
#include "mirror.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/pose/convex_hull.h"
#include "rectilin/pose/pose.h"

namespace rectilin::bench {
namespace {

const pose::Surface& surface() {
  static const pose::Surface made = pose::make_surface(smooth_mesh(5000));
  return made;
}

void posing(benchmark::State& state, const std::string& method, std::size_t faces) {
  const auto limit = threads(1);
  const pose::PoseMethod find = pose::pose_methods().make(method);
  const Mesh mesh = smooth_mesh(faces);
  for (auto _ : state) benchmark::DoNotOptimize(find(mesh).rotation);
}

/// One plane, judged by grid.
void by_grid(benchmark::State& state) {
  const pose::MirrorDefect defect(surface(), pose::convex_hull(surface().mesh));
  for (auto _ : state) benchmark::DoNotOptimize(defect.of(Vector3(0.6, 0.8, 0), 0));
}

/// The same by looking at every target sample for every reflected one.
void by_loop(benchmark::State& state) {
  const pose::Samples targets = pose::sample_surface(surface(), 8000), samples = pose::sample_surface(surface(), 800);
  const Vector3 normal(0.6, 0.8, 0);
  const double width = 0.09 * surface().rms;
  for (auto _ : state) {
    double sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vector3 point = samples.points[i] - 2 * normal.dot(samples.points[i]) * normal;
      const Vector3 turned = samples.normals[i] - 2 * normal.dot(samples.normals[i]) * normal;
      std::size_t nearest = 0;
      for (std::size_t j = 1; j < targets.size(); ++j)
        if ((targets.points[j] - point).squaredNorm() < (targets.points[nearest] - point).squaredNorm()) nearest = j;
      const double square = (targets.points[nearest] - point).squaredNorm(),
                   alike = turned.dot(targets.normals[nearest]);
      sum += std::exp(-square / (2 * width * width)) * alike * alike;
    }
    benchmark::DoNotOptimize(sum);
  }
}

}  // namespace

void register_pose_benchmarks() {
  for (const char* method : {"pca", "rectilinear", "hull", "box", "symmetry", "cpn", "composite"})
    benchmark::RegisterBenchmark((std::string("pose/") + method + "/5000").c_str(), posing, method, 5000)
        ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("pose/composite/100000", posing, "composite", 100'000)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("pose/mirror_defect/grid", by_grid)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("pose/mirror_defect/loop", by_loop)->Unit(benchmark::kMicrosecond);
}

}  // namespace rectilin::bench
