// Stores and archives: what a row costs, merging and exporting, and a mesh out of an archive against one out of a
// folder.
#include <archive.h>
#include <archive_entry.h>
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "rectilin/corpus/export_store.h"
#include "rectilin/corpus/merge.h"
#include "rectilin/corpus/store.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/mesh/source.h"

namespace rectilin::corpus {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("rectilin-bench-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

const Task kTask{"bench", Json::object()};

/// As large as the rows of measured meshes are: about a kilobyte.
Row row_number(std::int64_t i) {
  Row row;
  row.name = row.source = "collection/part_" + std::to_string(i % 100) + "/model_" + std::to_string(i) + ".off";
  row.status = RowStatus::kDone;
  row.digest = "fnv1a64:" + std::to_string(1'000'000'007 * i);
  const double x = 1 / static_cast<double>(i + 3);
  row.result = to_text(Json{{"faces", i},
                            {"directions", i},
                            {"area", x},
                            {"rectilinearity", x},
                            {"lower", x},
                            {"upper", x},
                            {"rotation", {{1 - x, x, x / 3}, {x, 1 - x, x}, {x / 7, x, 1 - x}}},
                            {"more", std::string(500, 'x')}});
  row.report = R"({"vertices":8,"polygons":12,"triangulated":0,"nonfinite_vertices":0,"dropped_nonfinite":0})";
  row.version = "1";
  row.finished = row.seconds = x;
  return row;
}

/// Into a store without a disk's waits between rows.
void fill(const fs::path& file, std::int64_t begin, std::int64_t end, std::int64_t step) {
  Store store(file, kTask);
  for (std::int64_t i = begin; i < end; i += step) store.put(row_number(i));
}

void put(benchmark::State& state) {
  const Folder folder;
  Store store(folder / "store.db", kTask);
  std::int64_t i = 0;
  for (auto _ : state) store.put(row_number(i++));
}
BENCHMARK(put)->Unit(benchmark::kMicrosecond);

void merging_and_exporting(benchmark::State& state) {
  const Folder folder;
  std::vector<fs::path> shards;
  for (int k = 0; k < 4; ++k) {
    shards.push_back(folder / ("shard" + std::to_string(k) + ".db"));
    fill(shards.back(), k, state.range(0), 4);
  }
  for (auto _ : state) {
    merge(shards, folder / "all.db");
    Store all(folder / "all.db");
    for (const char* name : {"all.csv", "all.jsonl", "all.npy"}) export_store(all, folder / name);
    state.PauseTiming();
    state.counters["bytes a row"] =
        static_cast<double>(fs::file_size(folder / "all.db")) / static_cast<double>(state.range(0));
    fs::remove(folder / "all.db");
    state.ResumeTiming();
  }
}
BENCHMARK(merging_and_exporting)->Arg(10'000)->Arg(1'000'000)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

/// Meshes of a thousand faces, in a folder and in an archive of the same.
struct Collection {
  Folder folder;
  std::vector<std::string> files, members;

  explicit Collection(std::int64_t count) {
    const std::string zip = (folder / "all.zip").string();
    archive* a = archive_write_new();
    archive_write_set_format_zip(a);
    archive_write_open_filename(a, zip.c_str());
    fs::create_directories(folder / "files");
    for (std::int64_t i = 0; i < count; ++i) {
      const fs::path file = folder / ("files/" + std::to_string(100'000 + i) + ".off");
      write_mesh(file, make_shape(Spec::parse("blob?faces=1000&seed=" + std::to_string(i))));
      std::ostringstream text;
      text << std::ifstream(file, std::ios::binary).rdbuf();
      archive_entry* entry = archive_entry_new();
      archive_entry_set_pathname(entry, file.filename().c_str());
      archive_entry_set_size(entry, static_cast<la_int64_t>(text.str().size()));
      archive_entry_set_filetype(entry, AE_IFREG);
      archive_write_header(a, entry);
      archive_write_data(a, text.str().data(), text.str().size());
      archive_entry_free(entry);
    }
    archive_write_close(a);
    archive_write_free(a);
    files = expand_folders({(folder / "files").string()});
    members = expand_folders({zip});
  }
};

void read_all(benchmark::State& state, const std::vector<std::string>& sources) {
  for (auto _ : state)
    for (const std::string& source : sources) benchmark::DoNotOptimize(load_mesh(source).mesh.triangles.size());
}

void reading_files(benchmark::State& state) { read_all(state, Collection(state.range(0)).files); }
void reading_zip(benchmark::State& state) { read_all(state, Collection(state.range(0)).members); }
void reading_every_second_of_zip(benchmark::State& state) {
  const Collection collection(state.range(0));
  std::vector<std::string> half;
  for (std::size_t i = 0; i < collection.members.size(); i += 2) half.push_back(collection.members[i]);
  read_all(state, half);
}
BENCHMARK(reading_files)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(reading_zip)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(reading_every_second_of_zip)->Arg(2000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rectilin::corpus

BENCHMARK_MAIN();
