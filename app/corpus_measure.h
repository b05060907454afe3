// Measures into a store instead of printing.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/corpus/worker.h"

namespace rectilin::app {

/// The options of a command that works on a corpus, besides what to do with each mesh.
struct CorpusArguments {
  std::string store;  ///< the store's file; empty for none
  std::string shard = "0/1";
  std::optional<std::uint64_t> memory;
  bool retry = false;
  std::vector<std::string> done;

  /// Was anything given that needs a store?
  bool is_used() const { return shard != "0/1" || memory || retry || !done.empty(); }
};

void add_corpus_options(CLI::App& command, CorpusArguments& arguments);

/// Does a value of -o name a store rather than an optimizer?
bool is_store_name(const std::string& text);

/// Works on the sources that are in the shard and not in the store, in `threads` worker processes of this program (0:
/// one for each processor). Returns the exit status.
int work_into_store(const std::vector<std::string>& sources, const corpus::Task& task, const CorpusArguments& arguments,
                    std::optional<double> seconds, int threads);

/// What workers do for a task; there is one, "measure".
corpus::Work make_work(const corpus::Task& task, std::optional<double> seconds);

}  // namespace rectilin::app
