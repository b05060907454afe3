// What commands that work on a corpus share: their options, and runs in worker processes into stores.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rectilin/corpus/run_corpus.h"

namespace rectilin::app {

/// The options of a command that works on a corpus, besides what to do with each mesh.
struct CorpusArguments {
  std::string store;  ///< the store's file; empty for none
  std::string shard = "0/1";
  std::optional<std::uint64_t> memory;
  bool retry = false;
  std::vector<std::string> done;

  /// Throws ParameterError if anything was given that needs a store, and no store was.
  void check() const;
};

/// Adds the options of shards and limits; before them that of the store, by these names, if there are any. `note` says
/// when they can be used.
void add_corpus_options(CLI::App& command, CorpusArguments& arguments, const std::string& out, const std::string& note);

/// Adds --seconds for a command that has no such option of its own.
void add_seconds_option(CLI::App& command, std::optional<double>& seconds);

/// Does a value of -o name a store?
bool is_store_name(const std::string& text);

/// Worker processes of this program: `threads` of them (0: one for each processor), with limits for each mesh.
corpus::WorkerOptions worker_options(const CorpusArguments& arguments, std::optional<double> seconds, int threads);

/// Works into a store on those of the meshes that are in the shard and not in the store. If results depend on the names
/// of the meshes, equal meshes cannot `share` them. `what` the rows are is for messages. Returns the exit status.
int work_into_store(const std::vector<NamedSource>& meshes, const corpus::Task& task, const CorpusArguments& arguments,
                    const corpus::WorkerOptions& workers, bool share = true, const std::string& what = "meshes");

}  // namespace rectilin::app
