#include "corpus_run.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>
#include <thread>

#include "options.h"
#include "rectilin/mesh/source.h"
#include "terminal.h"

namespace rectilin::app {

void CorpusArguments::check() const {
  if (store.empty() && (shard != "0/1" || memory || retry || !done.empty()))
    throw ParameterError("--shard, --memory, --retry and --done need a store: -O FILE.db");
}

void add_corpus_options(CLI::App& command, CorpusArguments& arguments, const std::string& out,
                        const std::string& note) {
  if (!out.empty())
    command.add_option(out, arguments.store,
                       "Store FILE.db to write results to instead of printing them. Meshes that are in it are not done "
                       "again");
  command.add_option("--shard", arguments.shard, "Part I/N of the meshes, 0 <= I < N, chosen by their names" + note)
      ->capture_default_str();
  command.add_option("--memory", arguments.memory, "Memory at most, per mesh, in bytes or with a unit (500M, 2G)")
      ->transform(CLI::AsSizeValue(false));
  command.add_flag("--retry", arguments.retry, "Do meshes again that failed, took too long or took too much memory");
  command.add_option("--done", arguments.done, "Other files of results, whose meshes need not be done again")
      ->allow_extra_args(false);
}

void add_seconds_option(CLI::App& command, std::optional<double>& seconds) {
  command.add_option("--seconds", seconds, "Seconds at most, per mesh, reading included (default: no limit)")
      ->check(positive_number());
}

bool is_store_name(const std::string& text) { return text.ends_with(".db"); }

corpus::WorkerOptions worker_options(const CorpusArguments& arguments, std::optional<double> seconds, int threads) {
  corpus::WorkerOptions options;
  options.worker_command = {std::filesystem::read_symlink("/proc/self/exe").string(), "corpus", "worker"};
  options.workers = threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.seconds = seconds;
  options.memory = arguments.memory;
  return options;
}

int work_into_store(const std::vector<NamedSource>& meshes, const corpus::Task& task, const CorpusArguments& arguments,
                    const corpus::WorkerOptions& workers, bool share, const std::string& what) {
  if (meshes.empty()) throw MeshError("the list of files is empty");
  const corpus::Shard shard = corpus::Shard::parse(arguments.shard);
  corpus::CorpusOptions options;
  static_cast<corpus::WorkerOptions&>(options) = workers;
  options.share = share;
  options.retry = arguments.retry;
  options.done.assign(arguments.done.begin(), arguments.done.end());
  corpus::Store store(arguments.store, task);

  std::optional<Progress> progress;
  const auto on_progress = [&](std::size_t done, std::size_t total, const std::string& name) {
    if (!progress) progress.emplace(total);
    progress->show(done, name);
  };
  std::set<std::string> told;  // many rows may be about one mesh
  options.on_row = [&](const corpus::Row& row, const std::string& left_out) {
    if (row.error.empty() && left_out.empty()) return;
    if (progress) progress->clear();
    if (!row.error.empty() && (share || told.insert(row.source + row.error).second))
      complain(error_about(row.name, row.error));
    if (!left_out.empty() && (share || told.insert(row.source).second)) complain(row.source + ": " + left_out);
  };
  const corpus::CorpusSummary summary =
      corpus::run_corpus(meshes, shard, store, task, options, {stop_on_interrupt(), on_progress});
  if (progress) progress->clear();
  std::cout << arguments.store << ": " << summary.done << " done";
  if (summary.copied > 0) std::cout << " (" << summary.copied << " of them equal to others)";
  std::cout << ", " << summary.failed << " failed, " << summary.limited << " limited, " << summary.before
            << " were there before\n";
  if (summary.left > 0) complain("stopped: " + std::to_string(summary.left) + " " + what + " are left");
  // Meshes that failed have rows. The meshes in a folder that could not be listed have none.
  const bool folder_missed = std::ranges::any_of(meshes, [](const NamedSource& mesh) {
    std::error_code unknown;
    return std::filesystem::is_directory(mesh.source, unknown);
  });
  return summary.left > 0 || folder_missed ? 1 : 0;
}

}  // namespace rectilin::app
