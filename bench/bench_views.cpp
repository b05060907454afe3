// Pictures and silhouette areas: against a plain loop over triangles and pixels, in turns, on one thread.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "bench.h"
#include "inputs.h"
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

/// What anybody would write: barycentric coordinates of every pixel in a triangle's box, one view after the other.
DepthImage plain_picture(const Mesh& mesh, const Ball& ball, const Rotation& frame) {
  DepthImage image{kSize, std::vector<std::uint16_t>(kSize * kSize, 0)};
  std::vector<Vector3> points;
  for (const Vector3& p : mesh.vertices) {
    const Vector3 q = frame.matrix() * (p - ball.centre) / ball.radius;
    points.emplace_back((q.x() + 1) * kSize / 2, (1 - q.y()) * kSize / 2, 32768 + 32767 * q.z());
  }
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vector3 &a = points[ia], &b = points[ib], &c = points[ic];
    const auto side = [](const Vector3& p, const Vector3& q, double x, double y) {
      return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
    };
    const double area = side(a, b, c.x(), c.y());
    if (area == 0) continue;
    const int left = std::max(0, static_cast<int>(std::ceil(std::min({a.x(), b.x(), c.x()}) - 0.5)));
    const int right = std::min(kSize - 1, static_cast<int>(std::floor(std::max({a.x(), b.x(), c.x()}) - 0.5)));
    const int top = std::max(0, static_cast<int>(std::ceil(std::min({a.y(), b.y(), c.y()}) - 0.5)));
    const int bottom = std::min(kSize - 1, static_cast<int>(std::floor(std::max({a.y(), b.y(), c.y()}) - 0.5)));
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const double wa = side(b, c, x + 0.5, y + 0.5) / area, wb = side(c, a, x + 0.5, y + 0.5) / area;
        const double wc = 1 - wa - wb;
        if (wa < 0 || wb < 0 || wc < 0) continue;
        std::uint16_t& pixel = image.depth[static_cast<std::size_t>(y * kSize + x)];
        pixel = std::max(pixel, static_cast<std::uint16_t>(wa * a.z() + wb * b.z() + wc * c.z()));
      }
  }
  return image;
}

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
          seen += plain_picture(mesh, ball, render::frame_towards(d)).depth[kSize * kSize / 2];
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
        plain_seconds += plain.time(
            [&] { seen += static_cast<double>(plain_picture(mesh, ball, render::frame_towards(d)).covered_pixels()); });
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
