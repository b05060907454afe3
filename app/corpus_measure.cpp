#include "corpus_measure.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include "rectilin/corpus/run_corpus.h"
#include "rectilin/corpus/store.h"
#include "rectilin/measure/measure.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

/// Results leave out times, which differ between equal runs; the rows of the store have columns for them.
constexpr const char* kTimes[] = {"seconds", "cpu_seconds", "threads"};

corpus::Work measure_work(const Json& settings, std::optional<double> seconds) {
  MeasureOptions options = measure_options(settings["optimizer"].get<std::string>(), all_optimizers());
  if (!settings["gap"].is_null()) options.certify.gap = settings["gap"];
  if (settings["optima"] == true) options.certify.optima = true;
  options.run.seed = settings["seed"];
  options.run.domain = &domain_by_name(settings["domain"].get<std::string>());
  Budget& budget = options.run.budget;
  if (!settings["evaluations"].is_null()) budget.evaluations = settings["evaluations"].get<std::uint64_t>();
  if (seconds) budget.seconds = *seconds;
  return [options](const LoadedMesh& mesh) {
    const Rectilinearity r = measure(mesh.mesh, options);
    corpus::WorkResult done{to_json(r), false};
    done.time_over = r.run.outcome == RunRecord::Outcome::kBudget && options.run.budget.limits_seconds() &&
                     r.run.costs.evaluations() < options.run.budget.evaluations;
    for (const char* key : kTimes) done.result.erase(key);
    return done;
  };
}

}  // namespace

void add_corpus_options(CLI::App& command, CorpusArguments& arguments) {
  command.add_option("-O,--out", arguments.store,
                     "Store FILE.db to write results to instead of printing them; the same as -o FILE.db. Meshes that "
                     "are in it are not done again");
  command
      .add_option("--shard", arguments.shard,
                  "Part I/N of the meshes, 0 <= I < N, chosen by their names (with a store)")
      ->capture_default_str();
  command
      .add_option("--memory", arguments.memory,
                  "Memory at most, per mesh, in bytes or with a unit (500M, 2G); with a store, like all that follows")
      ->transform(CLI::AsSizeValue(false));
  command.add_flag("--retry", arguments.retry, "Do meshes again that failed, took too long or took too much memory");
  command.add_option("--done", arguments.done, "Stores whose meshes need not be done again");
}

bool is_store_name(const std::string& text) { return text.ends_with(".db"); }

corpus::Work make_work(const corpus::Task& task, std::optional<double> seconds) {
  if (task.name == "measure") return measure_work(task.settings, seconds);
  throw ParameterError("no task '" + task.name + "'");
}

int work_into_store(const std::vector<std::string>& sources, const corpus::Task& task, const CorpusArguments& arguments,
                    std::optional<double> seconds, int threads) {
  const corpus::Shard shard = corpus::Shard::parse(arguments.shard);
  const std::vector<NamedSource> meshes = expand_sources(sources);
  if (meshes.empty()) throw MeshError("the list of files is empty");
  corpus::CorpusOptions options;
  options.worker_command = {std::filesystem::read_symlink("/proc/self/exe").string(), "corpus", "worker"};
  options.workers = threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.seconds = seconds;
  options.memory = arguments.memory;
  options.retry = arguments.retry;
  options.done.assign(arguments.done.begin(), arguments.done.end());
  corpus::Store store(arguments.store, task);

  std::optional<Progress> progress;
  const auto on_progress = [&](std::size_t done, std::size_t total, const std::string& name) {
    if (!progress) progress.emplace(total);
    progress->show(done, name);
  };
  options.on_row = [&](const corpus::Row& row, const std::string& left_out) {
    if (row.error.empty() && left_out.empty()) return;
    if (progress) progress->clear();
    if (!row.error.empty()) complain(error_about(row.name, row.error));
    if (!left_out.empty()) complain(row.source + ": " + left_out);
  };
  const corpus::CorpusSummary summary =
      corpus::run_corpus(meshes, shard, store, task, options, {stop_on_interrupt(), on_progress});
  if (progress) progress->clear();
  std::cout << arguments.store << ": " << summary.done << " done";
  if (summary.copied > 0) std::cout << " (" << summary.copied << " of them equal to others)";
  std::cout << ", " << summary.failed << " failed, " << summary.limited << " limited, " << summary.before
            << " were there before\n";
  if (summary.left > 0) complain("stopped: " + std::to_string(summary.left) + " meshes are left");
  // Meshes that failed have rows. The meshes in a folder that could not be listed have none.
  const bool folder_missed = std::ranges::any_of(meshes, [](const NamedSource& mesh) {
    std::error_code unknown;
    return std::filesystem::is_directory(mesh.source, unknown);
  });
  return summary.left > 0 || folder_missed ? 1 : 0;
}

}  // namespace rectilin::app
