// rectilin compare: runs optimizers against each other on meshes, on the same budget, and makes a page of the results.
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>

#include "commands.h"
#include "compare_store.h"
#include "corpus_run.h"
#include "options.h"
#include "rectilin/base/printable.h"
#include "rectilin/laboratory/comparison.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct CompareOptions {
  std::vector<std::string> sources;
  std::vector<std::string> optimizers;
  std::vector<std::string> domains = {"covering"};
  laboratory::Plan plan;
  std::string out = "comparison", from;
  int threads = 0;
  std::optional<double> seconds;
  CorpusArguments corpus;
};

/// Can the optimizer work on an objective that offers nothing but values?
bool asks_for_values(const Registry& registry, std::string_view spec) {
  const Capabilities needs = registry.make(spec)->capabilities();
  return !needs.needs_cuts && !needs.needs_smooth && !needs.needs_turns;
}

/// The search for the best known value where nothing can be proved.
constexpr const char* kReference = "super-fibonacci?count=2000+nelder-mead";

/// The optimizers that are compared if none are named: those of this list that the build has and, unless `all`, that
/// need only values.
std::vector<std::string> default_optimizers(const Registry& registry, bool all) {
  std::vector<std::string> present;
  for (const char* wish : {"ga", "gray-ga=ga?encoding=gray&selection=tournament", "grid", "random", "super-fibonacci",
                           "anneal", "multistart", "axis-sweep", "hybrid", "ceres", "nlopt:GN_DIRECT_L",
                           "nlopt:GN_CRS2_LM", "pagmo:cmaes", "pagmo:sade"}) {
    const std::string_view spec = laboratory::split_label(wish).spec;
    for (const Registry::Entry& entry : registry.entries())
      if (entry.name == spec.substr(0, spec.find('?')) && (all || asks_for_values(registry, spec)))
        present.push_back(wish);
  }
  return present;
}

/// Takes the store out of the values of -o, which ends in .db; the others are optimizers.
void take_store(CompareOptions& options) {
  std::erase_if(options.optimizers, [&](const std::string& value) {
    if (!is_store_name(value)) return false;
    if (!options.corpus.store.empty()) throw ParameterError("-o: more than one store");
    options.corpus.store = value;
    return true;
  });
}

int compare(CompareOptions options, const std::string& command_line) {
  take_store(options);
  if (!options.from.empty()) {
    if (!options.sources.empty() || !options.optimizers.empty() || !options.corpus.store.empty())
      throw ParameterError("--from takes meshes and optimizers from the store; none can be given");
    return compare_from_store(options.from, options.out, command_line);
  }
  if (options.sources.empty()) throw ParameterError("no source: give meshes, or a store with --from");
  options.corpus.check();
  const Registry& registry = all_optimizers();
  laboratory::Plan& plan = options.plan;
  plan.meshes = expand_folders(options.sources);
  if (options.optimizers.empty()) options.optimizers = default_optimizers(registry, plan.proves());
  if (!plan.proves() && plan.certificate == laboratory::Plan().certificate) plan.certificate = kReference;
  plan.entries = laboratory::parse_entries(options.optimizers, options.domains, registry);

  if (!options.corpus.store.empty()) {
    laboratory::check(plan, registry);
    return work_into_store(compare_jobs(plan), compare_task(plan), options.corpus,
                           worker_options(options.corpus, options.seconds, options.threads), false, "runs");
  }
  if (options.seconds) throw ParameterError("--seconds needs a store: -o FILE.db");
  const auto limit = limit_threads(options.threads);

  laboratory::ComparisonOutcome outcome;
  {
    std::unique_ptr<Progress> progress;
    laboratory::ComparisonSettings settings;
    settings.stop = stop_on_interrupt();
    settings.command_line = command_line;
    settings.report = true;
    LoadedMesh loaded;  // read once: it may come through a pipe
    settings.load = [&](const std::string& name) {
      loaded = load_mesh(name);
      return laboratory::compared_mesh(loaded);
    };
    settings.objective = [&](const std::string& name) { return other_objective(loaded, name); };
    settings.on_progress = [&](const laboratory::ComparisonProgress& now) {
      if (!progress) progress = std::make_unique<Progress>(plan.meshes.size() * plan.entries.size() * plan.runs);
      progress->show(now.done, time_left(now.seconds_left) + now.text);
    };
    outcome = laboratory::run_comparison(plan, options.out, registry, settings);
  }
  for (const std::string& error : outcome.mesh_errors) complain(error);
  for (const std::string& loss : outcome.losses) complain(loss);
  if (!outcome.complete) {
    complain("stopped; nothing finished is lost: the same command goes on from here");
    return 1;
  }
  for (const std::string& trouble : outcome.pictures.lines) complain(trouble);
  if (outcome.failed_runs > 0) complain(std::to_string(outcome.failed_runs) + " runs failed; the page lists them");
  std::cout << printable(options.out) << "/index.html\n";
  return outcome.mesh_errors.empty() && !outcome.pictures.failed ? 0 : 1;
}

}  // namespace

void add_compare_command(CLI::App& app, int& status, int argc, const char* const* argv) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "Compare optimizers and write a page with the result");
  command->add_option("source", options->sources,
                      "Mesh files, folders of them, built-in shapes (shape:NAME?key=value)");
  command
      ->add_option(
          "-o,--optimizers", options->optimizers,
          "Optimizers separated by commas or blanks; may be repeated. Each as 'rectilin optimizers' shows it, with "
          "parameters (ga?population=100), as a pipeline (grid+nelder-mead), and with the box it searches after an @ "
          "(ga@paper, ga@zone). NAME= in front gives it another name. Default: a selection. Or a store, FILE.db, to "
          "write runs to, without a page")
      ->allow_extra_args(false);
  command
      ->add_option("-k,--runs", options->plan.runs,
                   "Runs of each optimizer on each mesh, each on another random rotation of it")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("-b,--budget", options->plan.budget, "Evaluations for each run")
      ->check(count())
      ->capture_default_str();
  command->add_option("-s,--seed", options->plan.seed, "Seed of the rotations and the runs")
      ->check(seed())
      ->capture_default_str();
  command
      ->add_option("-d,--domain,--domains", options->domains,
                   "Box for optimizers that search one and name none: paper, covering or zone; several, separated by "
                   "commas, give an entry for each and a table of what the choice of domain costs")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"paper", "covering", "zone"}))
      ->capture_default_str();
  command->add_option("-O,--out", options->out, "Folder for the results")->capture_default_str();
  command
      ->add_option("--objective", options->plan.objective,
                   "What is optimized: rectilinearity, or silhouette (the summed area of three silhouettes over the "
                   "surface's area; nothing can be proved about it, so gaps are to the best value found)")
      ->check(CLI::IsMember({laboratory::kRectilinearity, "silhouette"}))
      ->capture_default_str();
  command
      ->add_option("-c,--certificate", options->plan.certificate,
                   "Optimizer that proves bounds of R for each mesh; gaps are measured from them")
      ->capture_default_str();
  command->add_option("--from", options->from,
                      "Make the page from a store, which was written by 'compare -o FILE.db' or merged from several");
  add_threads_option(*command, options->threads, "each run has one to itself");
  add_corpus_options(*command, options->corpus, "", "; here of the runs, with a store, like all that follows");
  command->add_option("--seconds", options->seconds, "Seconds at most, per run (with a store; default: no limit)")
      ->check(positive_number());
  command->footer(
      "First bounds of R are proved for each mesh; then every optimizer gets the same number of evaluations on the\n"
      "same random rotations. Finished runs are kept: after Ctrl-C (exit status 1) the same command resumes where it\n"
      "stopped. OUT/index.html shows gaps to the optimum, runtimes, rankings and tests, and OUT has the same as CSV "
      "and\n"
      "JSON; OUT/ioh is for IOHanalyzer. The plots need gnuplot.\n"
      "Examples: rectilin compare shape:pyramid shape:blob --runs 5 --budget 1000\n"
      "          rectilin compare meshes/ --optimizers 'ga, ga?encoding=gray, random' --out gray\n"
      "          rectilin compare chair.off --optimizers ga,grid --domains paper,covering,zone\n"
      "          rectilin compare meshes/ -o ga,grid -o part-3.db --shard 3/16\n"
      "          rectilin merge part-*.db -o all.db; rectilin compare --from all.db --out page");
  command->callback([options, &status, argc, argv] { status = compare(*options, quoted_command_line(argc, argv)); });
}

}  // namespace rectilin::app
