// rectilin merge, export and corpus: commands that work on stores.
#include <cmath>
#include <iostream>
#include <memory>

#include "commands.h"
#include "corpus_tasks.h"
#include "options.h"
#include "rectilin/corpus/export_store.h"
#include "rectilin/corpus/merge.h"
#include "rectilin/corpus/status.h"
#include "rectilin/corpus/worker.h"
#include "rectilin/search/database.h"
#include "rectilin/search/merge_databases.h"
#include "rectilin/search/status.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

/// A duration in hours and minutes, if it is that long.
std::string duration(double seconds) {
  if (seconds < 100) return fixed(seconds, 0) + " s";
  if (seconds < 6000) return fixed(seconds / 60, 0) + " min";
  return seconds < 360'000 ? fixed(seconds / 3600, 1) + " h" : fixed(seconds / 86400, 1) + " days";
}

int merge_stores(const std::vector<std::string>& stores, const std::string& target) {
  const std::vector<std::filesystem::path> files(stores.begin(), stores.end());
  const bool shapes = search::is_database(files.front());
  for (const auto& file : files)
    if (search::is_database(file) != shapes && std::filesystem::exists(file))
      throw ParameterError(file.string() + " and " + files.front().string() +
                           ": a store of results and a database of shapes cannot be merged");
  const corpus::MergeSummary summary = shapes ? search::merge_databases(files, target) : corpus::merge(files, target);
  for (const corpus::Conflict& conflict : summary.first)
    complain(conflict.name + " in " + conflict.store + ": " + conflict.reason + "; the target keeps its own");
  std::cout << target << ": " << summary.rows << " meshes, " << summary.added << " added, " << summary.conflicts
            << " conflicts\n";
  return summary.conflicts > 0 ? 1 : 0;
}

int show_status(const std::vector<std::string>& stores, bool check) {
  std::size_t widest = 5;
  for (const std::string& store : stores) widest = std::max(widest, store.size());
  const Table table({{"store", widest},
                     {"shard", 7},
                     {"", 7},
                     {"done", 9},
                     {"failed", 7},
                     {"limited", 7},
                     {"left", 9},
                     {"a second", 9},
                     {"time left", 9}});
  std::cout << table.header() << '\n';
  corpus::StoreStatus all;
  bool failed = false;
  double longest = 0;
  for (const std::string& store : stores) {
    try {
      const corpus::StoreStatus s = search::is_database(store) ? search::status_of(store) : corpus::status_of(store);
      const bool has_rate = s.rate > 0;
      std::cout << table.row({store, s.shard.empty() ? "-" : s.shard, s.running ? "running" : "",
                              std::to_string(s.done), std::to_string(s.failed), std::to_string(s.limited),
                              std::to_string(s.left), has_rate ? general(s.rate, 3) : "-",
                              s.left == 0 ? "-"
                              : has_rate  ? duration(*s.seconds_left)
                                          : "?"})
                << '\n';
      all.done += s.done;
      all.failed += s.failed;
      all.limited += s.limited;
      all.left += s.left;
      if (s.running) all.rate += s.rate;
      if (s.left > 0) longest = std::max(longest, has_rate ? *s.seconds_left : INFINITY);
    } catch (const std::exception& e) {
      complain(e.what());
      failed = true;
    }
  }
  if (stores.size() > 1)
    std::cout << table.row({"all", "", "", std::to_string(all.done), std::to_string(all.failed),
                            std::to_string(all.limited), std::to_string(all.left),
                            all.rate > 0 ? general(all.rate, 3) : "-",
                            all.left == 0            ? "-"
                            : std::isfinite(longest) ? duration(longest)
                                                     : "?"})
              << '\n';
  return failed || (check && all.left > 0) ? 1 : 0;
}

void add_merge(CLI::App& app, int& status) {
  struct Options {
    std::vector<std::string> stores;
    std::string target;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("merge", "Merge stores or databases of shapes, such as those of shards");
  command
      ->add_option("store", options->stores,
                   "Stores, written by 'measure', 'pose' or 'compare' with -o FILE.db, or databases of 'index'")
      ->required();
  command->add_option("-o,-O,--out", options->target, "Store to add them to; made if it does not exist")->required();
  command->footer(
      "If several stores have a mesh, the row that says most is kept; merging twice changes nothing. Results that\n"
      "differ are conflicts: they are reported, and the exit status is 1.\n"
      "Example: rectilin merge shard-*.db -o all.db");
  command->callback([options, &status] { status = merge_stores(options->stores, options->target); });
}

void add_export(CLI::App& app, int& status) {
  struct Options {
    std::string store;
    std::vector<std::string> files;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write a store as CSV, JSON lines or a NumPy array");
  command->add_option("store", options->store, "Store")->required();
  command->add_option("-o,-O,--out", options->files,
                      "Files to write: .csv, .jsonl, .npy (default: all three, named as the store)");
  command->footer(
      "Example: rectilin export all.db -o all.csv -o all.npy\n         python3 -c \"import numpy; "
      "print(numpy.load('all.npy')['rectilinearity'])\"");
  command->callback([options, &status] {
    corpus::Store store(options->store);
    std::vector<std::string> files = options->files;
    if (files.empty())
      for (const char* extension : {".csv", ".jsonl", ".npy"})
        files.push_back(std::filesystem::path(options->store).replace_extension(extension).string());
    for (const std::string& file : files) {
      corpus::export_store(store, file);
      std::cout << file << '\n';
    }
    status = 0;
  });
}

}  // namespace

void add_corpus_commands(CLI::App& app, int& status) {
  add_merge(app, status);
  add_export(app, status);
  CLI::App* corpus = app.add_subcommand("corpus", "Progress of runs on a corpus");
  corpus->require_subcommand(1);

  struct Options {
    std::vector<std::string> stores;
    bool check = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* show = corpus->add_subcommand("status", "Meshes done, failed, limited and left, rates, and the time left");
  show->add_option("store", options->stores, "Stores, which may be in use")->required();
  show->add_flag("--check", options->check, "Exit status 1 if meshes are left");
  show->callback([options, &status] { status = show_status(options->stores, options->check); });

  CLI::App* worker = corpus->add_subcommand("worker", "");
  worker->group("");  // not shown in the help: the program runs it itself
  worker->callback([&status] {
    const auto limit = limit_threads(1);
    status = corpus::run_worker(3, make_work);
  });
}

}  // namespace rectilin::app
