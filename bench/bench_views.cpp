// Pictures and silhouette areas: against a plain loop over triangles and pixels, in turns, on one thread.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "bench.h"
#include "inputs.h"
#include "plain_picture.h"
#include "rectilin/mesh/source.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/render/silhouette_area.h"
#include "stopwatch.h"

namespace rectilin::bench {
namespace {

using render::Ball;
using render::DepthImage;
using render::ViewSphere;

constexpr int kSize = 256;

void views(benchmark::State& state, const std::vector<std::string>& sources) {
  const auto limit = threads(1);
  const ViewSphere sphere(2);
  std::vector<Mesh> meshes;
  for (const std::string& source : sources) meshes.push_back(load_mesh(source).mesh);
  Stopwatch ours(thread_seconds), plain(thread_seconds);
  double our_seconds = 0, plain_seconds = 0, seen = 0;
  for (auto _ : state)
    for (const Mesh& mesh : meshes) {
      const Ball ball = render::ball_around(mesh);
      our_seconds += ours.time([&] {
        render::visit_views(mesh, ball, sphere, {.size = kSize}, {}, [&](std::size_t, const DepthImage& image) {
          benchmark::DoNotOptimize(image.depth.data());
        });
      });
      plain_seconds += plain.time([&] {
        for (const Vector3& d : sphere.directions())
          seen += plain_picture(mesh, ball, render::frame_towards(d), kSize).depth[kSize * kSize / 2];
      });
    }
  benchmark::DoNotOptimize(seen);
  const double runs = static_cast<double>(state.iterations()) * static_cast<double>(meshes.size());
  state.counters["ms_a_mesh"] = 1e3 * our_seconds / runs;
  state.counters["plain_over_ours"] = plain_seconds / our_seconds;
}

/// Areas to 1e-6 over the plain loop's pictures of 256 x 256, whose pixels give an area to a percent.
void silhouettes(benchmark::State& state, const std::vector<std::string>& sources, double tolerance) {
  const ViewSphere sphere(1);
  double our_seconds = 0, plain_seconds = 0, making = 0, worst = 0, seen = 0, areas = 0, meshes = 0;
  for (auto _ : state)
    for (const std::string& source : sources) {
      const Mesh mesh = load_mesh(source).mesh;
      const Ball ball = render::ball_around(mesh);
      const double start = thread_seconds();
      const render::Silhouette silhouette(mesh);
      making += thread_seconds() - start;
      meshes += 1;
      for (std::size_t k = 0; k < sphere.size(); k += 2) {
        const Vector3 d = sphere.directions()[k] + Vector3(0.013, 0.021, 0.034);  // no wall edge on
        Stopwatch ours(thread_seconds), plain(thread_seconds);
        const double seconds = ours.time([&] { benchmark::DoNotOptimize(silhouette.area(d, tolerance).lower); });
        our_seconds += seconds;
        worst = std::max(worst, seconds);
        plain_seconds += plain.time([&] {
          seen += static_cast<double>(plain_picture(mesh, ball, render::frame_towards(d), kSize).covered_pixels());
        });
        areas += 1;
      }
    }
  benchmark::DoNotOptimize(seen);
  state.counters["ms_an_area"] = 1e3 * our_seconds / areas;
  state.counters["ms_worst"] = 1e3 * worst;
  state.counters["ms_making"] = 1e3 * making / meshes;
  state.counters["plain_over_ours"] = plain_seconds / our_seconds;
}

void add(const std::string& name, const std::vector<std::string>& sources) {
  benchmark::RegisterBenchmark(("views/" + name).c_str(), views, sources)->Iterations(1)->Unit(benchmark::kMillisecond);
  for (const auto& [text, tolerance] : {std::pair("1e-3", 1e-3), std::pair("1e-6", 1e-6)})
    benchmark::RegisterBenchmark(("silhouette/" + name + "/tolerance:" + text).c_str(), silhouettes, sources, tolerance)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_view_benchmarks() {
  add("blob/faces:100000", {"shape:blob?faces=100000"});
  const char* data = std::getenv("RECTILIN_DATA");
  if (data == nullptr) return;
  const std::filesystem::path models = std::filesystem::path(data) / "psb" / "off";
  if (std::filesystem::is_directory(models)) add("psb", expand_folders({models.string()}));
}

}  // namespace rectilin::bench
