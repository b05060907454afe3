// Time of the pose methods, on one thread, and beside the plain loops they replace, in turns.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "bench.h"
#include "frames.h"
#include "inputs.h"
#include "mirror.h"
#include "plain_picture.h"
#include "rectilin/base/random.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"
#include "rectilin/pose/convex_hull.h"
#include "rectilin/pose/pose.h"
#include "stopwatch.h"

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
double plain_defect(const pose::Samples& targets, const pose::Samples& samples, const Vector3& normal, double width) {
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vector3 point = samples.points[i] - 2 * normal.dot(samples.points[i]) * normal;
    const Vector3 turned = samples.normals[i] - 2 * normal.dot(samples.normals[i]) * normal;
    std::size_t nearest = 0;
    double least = (targets.points[0] - point).squaredNorm();
    for (std::size_t j = 1; j < targets.size(); ++j)
      if (const double square = (targets.points[j] - point).squaredNorm(); square < least) least = square, nearest = j;
    const double alike = turned.dot(targets.normals[nearest]);
    sum += std::exp(-least / (2 * width * width)) * alike * alike;
  }
  return 1 - sum / static_cast<double>(samples.size());
}

void by_loop(benchmark::State& state) {
  const pose::Samples targets = pose::sample_surface(surface(), 8000), samples = pose::sample_surface(surface(), 800);
  for (auto _ : state)
    benchmark::DoNotOptimize(plain_defect(targets, samples, Vector3(0.6, 0.8, 0), 0.09 * surface().rms));
}

/// The paper's rule as anybody would write it: the genetic algorithm's 50 x 200 sums over the faces (its section 4.2)
/// and six pictures. Random rotations stand for its generations; the cost is the same.
void plain_cpn(const Mesh& mesh) {
  const AreaVectors vectors = area_vectors(mesh);
  Random random(1);
  double least = 1e300;
  Rotation best;
  for (int i = 0; i < 50 * 200; ++i) {
    const Rotation frame = random_rotation(random);
    double sum = 0;
    for (std::size_t k = 0; k < vectors.size(); ++k) sum += (frame.matrix() * vectors[k]).lpNorm<1>();
    if (sum < least) least = sum, best = frame;
  }
  std::size_t pixels = 0;
  const render::Ball ball = render::ball_around(mesh);
  for (const Rotation& frame : {Rotation(), best})
    for (int k = 0; k < 3; ++k)
      pixels += plain_picture(mesh, ball, render::frame_towards(frame.axis(k)), 256).covered_pixels();
  benchmark::DoNotOptimize(pixels);
}

/// Of the composite only the scan for mirror planes: 2,000 planes, 250 samples, each compared with all 8,000 of the
/// surface. The rest, which is most of the work, is left out, so the ratio is too small rather than too large.
void plain_scan(const Mesh& mesh) {
  const pose::Surface surface = pose::make_surface(mesh);
  const pose::Samples targets = pose::sample_surface(surface, 8000), samples = pose::sample_surface(surface, 250);
  double least = 1;
  for (int i = 0; i < 2000; ++i)
    least = std::min(least, plain_defect(targets, samples, pose::hemisphere_point(i, 2000), 0.09 * surface.rms));
  benchmark::DoNotOptimize(least);
}

/// Ours and the plain one, turn by turn, over models of a benchmark or a blob.
void beside(benchmark::State& state, const std::string& method, void (*plain)(const Mesh&),
            const std::vector<std::string>& sources) {
  const auto limit = threads(1);
  const pose::PoseMethod find = pose::pose_methods().make(method);
  double ours = 0, theirs = 0, worst = 0;
  for (auto _ : state)
    for (const std::string& source : sources) {
      const Mesh mesh = load_mesh(source).mesh;
      const double start = thread_seconds();
      benchmark::DoNotOptimize(find(mesh).rotation);
      const double middle = thread_seconds();
      plain(mesh);
      theirs += thread_seconds() - middle;
      ours += middle - start;
      worst = std::max(worst, middle - start);
    }
  const double runs = static_cast<double>(state.iterations()) * static_cast<double>(sources.size());
  state.counters["ms_a_mesh"] = 1e3 * ours / runs;
  state.counters["ms_worst"] = 1e3 * worst;
  state.counters["plain_over_ours"] = theirs / ours;
}

void add_beside(const std::string& name, const std::vector<std::string>& sources) {
  benchmark::RegisterBenchmark(("pose/cpn/" + name).c_str(), beside, "cpn", plain_cpn, sources)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("pose/composite/" + name).c_str(), beside, "composite", plain_scan, sources)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

/// Every thirtieth model of the Princeton benchmark's half.
std::vector<std::string> some_models() {
  const char* data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) return {};
  const std::filesystem::path folder = std::filesystem::path(data) / "psb" / "off";
  if (!std::filesystem::is_directory(folder)) return {};
  std::vector<std::string> all = expand_folders({folder.string()}), some;
  for (std::size_t i = 0; i < all.size(); i += 30) some.push_back(all[i]);
  return some;
}

}  // namespace

void register_pose_benchmarks() {
  for (const char* method : {"pca", "rectilinear", "hull", "box", "symmetry", "cpn", "composite"})
    benchmark::RegisterBenchmark((std::string("pose/") + method + "/5000").c_str(), posing, method, 5000)
        ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("pose/composite/100000", posing, "composite", 100'000)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("pose/mirror_defect/grid", by_grid)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("pose/mirror_defect/loop", by_loop)->Unit(benchmark::kMicrosecond);
  add_beside("blob", {"shape:blob?faces=5000"});
  if (const std::vector<std::string> models = some_models(); !models.empty()) add_beside("psb", models);
}

}  // namespace rectilin::bench
