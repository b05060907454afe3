// Collections of small shapes, and how the tests run them.
#pragma once

#include "rectilin/corpus/run_corpus.h"
#include "support/catch.h"
#include "support/scratch_folder.h"

namespace rectilin::test {

/// Shapes that all differ; shape i has 2 (i + 3) + 2 (i + 3) - 4 faces.
inline std::vector<NamedSource> prisms(int count) {
  std::vector<NamedSource> meshes;
  for (int i = 0; i < count; ++i) {
    const std::string source = "shape:prism?sides=" + std::to_string(i + 3);
    meshes.push_back({"prism " + std::to_string(i), source, i % 2 ? "odd" : "even"});
  }
  return meshes;
}

inline std::size_t faces_of(const NamedSource& mesh) { return load_mesh(mesh.source).mesh.triangles.size(); }

inline corpus::CorpusOptions with_workers(int workers) {
  corpus::CorpusOptions options;
  options.worker_command = {RECTILIN_TEST_WORKER};
  options.workers = workers;
  return options;
}

/// All rows, without what differs between runs.
inline std::vector<corpus::Row> rows_of(const std::filesystem::path& file) {
  std::vector<corpus::Row> rows;
  corpus::Store(file).for_each([&](const corpus::Row& row) {
    rows.push_back(row);
    rows.back().finished = rows.back().seconds = 0;
  });
  return rows;
}

}  // namespace rectilin::test
