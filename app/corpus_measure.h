// Measuring into a store instead of onto the screen.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/corpus/worker.h"

namespace rectilin::app {

/// What a command that works on a corpus is told beside what to do with each mesh.
struct CorpusArguments {
  std::string store;  ///< empty: no store
  std::string shard = "0/1";
  std::optional<std::uint64_t> memory;
  bool retry = false;
  std::vector<std::string> done;

  /// Whether anything but the store is given.
  bool is_used() const { return shard != "0/1" || memory || retry || !done.empty(); }
};

void add_corpus_options(CLI::App& command, CorpusArguments& arguments);

/// Whether a value of -o is a store rather than an optimizer.
bool is_store_name(const std::string& text);

/// Works on the sources that are in the shard and not in the store, by processes of this program, as many as `threads`
/// (0: as there are processors). Returns the exit status.
int work_into_store(const std::vector<std::string>& sources, const corpus::Task& task, const CorpusArguments& arguments,
                    std::optional<double> seconds, int threads);

/// What the workers do for a task: "measure".
corpus::Work make_work(const corpus::Task& task, std::optional<double> seconds);

}  // namespace rectilin::app
