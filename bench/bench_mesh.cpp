// From files to area vectors.
#include <unistd.h>

#include <filesystem>

#include "bench.h"
#include "inputs.h"
#include "rectilin/mesh/mesh_io.h"

namespace rectilin::bench {
namespace {

namespace fs = std::filesystem;

/// A file that is gone when its reader is.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& extension)
      : path_(fs::temp_directory_path() / ("rectilin-bench-" + std::to_string(getpid()) + extension)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void reading(benchmark::State& state, const std::string& extension, bool binary, std::size_t faces) {
  const TemporaryFile file(extension);
  write_mesh(file.path(), smooth_mesh(faces), {.binary = binary});
  std::size_t triangles = 0;
  for (auto _ : state) triangles = read_mesh(file.path()).mesh.triangles.size();
  const auto reads = static_cast<double>(state.iterations());
  state.counters["faces/s"] = rate(reads * static_cast<double>(triangles));
  state.counters["bytes/s"] = rate(reads * static_cast<double>(fs::file_size(file.path())));
}

void measuring(benchmark::State& state, std::size_t faces, int thread_count) {
  const auto limit = threads(thread_count);
  const Mesh mesh = smooth_mesh(faces);
  for (auto _ : state) benchmark::DoNotOptimize(area_vectors(mesh).total);
  state.counters["faces/s"] =
      rate(static_cast<double>(state.iterations()) * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

void register_mesh_benchmarks() {
  struct Format {
    const char *name, *extension;
    bool binary;
  };
  constexpr std::size_t kFaces = 200'000;
  for (const Format& format :
       {Format{"off", ".off", false}, Format{"obj", ".obj", false}, Format{"ply_text", ".ply", false},
        Format{"ply_binary", ".ply", true}, Format{"stl_text", ".stl", false}, Format{"stl_binary", ".stl", true}})
    benchmark::RegisterBenchmark((std::string("read/") + format.name + pair("faces", kFaces)).c_str(), reading,
                                 format.extension, format.binary, kFaces)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  for (const std::size_t faces : {10'000u, 1'000'000u})
    for (const int thread_count : {1, 2})
      benchmark::RegisterBenchmark(
          ("area_vectors" + pair("faces", faces) + pair("threads", static_cast<std::size_t>(thread_count))).c_str(),
          measuring, faces, thread_count)
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
}

}  // namespace rectilin::bench
