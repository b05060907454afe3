// rectilin experiment: the paper's figures again, each as a reproducible program.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "commands.h"
#include "options.h"
#include "rectilin/base/printable.h"
#include "rectilin/mesh/source.h"
#include "rectilin/paper/experiment.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct ExperimentOptions {
  std::string spec;
  std::vector<std::string> meshes;
  std::string out = "figures";
  std::uint64_t seed = 1;
  std::optional<double> gap;
  std::string classes;
  int threads = 0;
  bool quick = false;
};

constexpr const char* kAll = "all";

void list() {
  std::cout << "rectilin experiment NAME runs one of these, rectilin experiment all runs all.\n\n";
  for (const paper::Experiment& experiment : paper::experiments()) {
    std::cout << experiment.name << "\n    " << experiment.help;
    if (!experiment.takes.empty()) std::cout << "; takes " << experiment.takes;
    std::cout << '\n' << settings_table(experiment.parameters);
  }
  std::cout << "\nSettings go behind the name: rectilin experiment 'fig15?steps=1000'\n"
               "Meshes come next, if it takes any: rectilin experiment fig13 teapot.obj dragon.obj\n"
               "Pictures, data and index.html, which shows all experiments made so far, go to the\n"
               "folder 'figures' or what --out says.\n";
}

class Runner {
 public:
  Runner(const ExperimentOptions& options, std::string command_line)
      : options_(options), command_line_(std::move(command_line)) {
    context_.meshes = expand_folders(options.meshes);
    context_.seed = options.seed;
    if (options.quick) context_.gap = 1e-3;
    if (options.gap) context_.gap = *options.gap;
    context_.stop = stop_on_interrupt();
  }

  /// Returns the exit status.
  int run(const paper::Experiment& experiment, const Json& given) {
    Json settings = options_.quick ? experiment.quick : Json::object();
    settings.update(given);
    paper::ExperimentOutcome outcome;
    {
      std::optional<Progress> progress;
      context_.on_progress = [&, of = std::size_t{0}](std::size_t done, std::size_t total,
                                                      const std::string& text) mutable {
        if (total != std::exchange(of, total)) progress.emplace(total);
        progress->show(done, experiment.name + ": " + text);
      };
      outcome = paper::run_experiment(experiment, settings, context_, options_.out, command_line_);
    }
    paper::write_experiment_page(options_.out);
    for (const std::string& error : outcome.mesh_errors) complain(error);
    for (const std::string& trouble : outcome.pictures.lines) complain(trouble);
    std::cout << experiment.name << ": " << printable(outcome.says) << '\n' << std::flush;
    return outcome.mesh_errors.empty() && !outcome.pictures.failed ? 0 : 1;
  }

 private:
  const ExperimentOptions& options_;
  std::string command_line_;
  paper::ExperimentContext context_;
};

int experiment(const ExperimentOptions& options, const std::string& command_line) {
  if (options.spec.empty()) {
    list();
    return 0;
  }
  const auto limit = limit_threads(options.threads);

  Runner runner(options, command_line);
  int status = 0;
  if (options.spec != kAll) {
    Spec spec = Spec::parse(options.spec);
    if (!options.classes.empty()) spec.settings["classes"] = options.classes;
    status = runner.run(paper::find_experiment(spec.name), spec.settings);
  } else {
    if (!options.meshes.empty() || !options.classes.empty())
      throw ParameterError("'all' takes no meshes; give them to one experiment at a time");
    for (const paper::Experiment& one : paper::experiments())
      status = std::max(status, runner.run(one, Json::object()));
  }
  std::cout << printable(options.out) << "/index.html\n";
  return status;
}

}  // namespace

void add_experiment_command(CLI::App& app, int& status, int argc, const char* const* argv) {
  auto options = std::make_shared<ExperimentOptions>();
  CLI::App* command = app.add_subcommand("experiment", "Make the paper's figures again");
  command->add_option("experiment", options->spec,
                      "Experiment, with settings: fig15?steps=32; or all. Without it: a list of "
                      "them with their settings");
  command->add_option("mesh", options->meshes,
                      "Mesh files, folders of them, built-in shapes (shape:NAME?key=value), for "
                      "experiments that take meshes; without, they make their own");
  command->add_option("-O,--out", options->out, "Folder for everything")->capture_default_str();
  command->add_option("-s,--seed", options->seed, "Seed of everything random")->check(seed())->capture_default_str();
  command->add_option("-g,--gap", options->gap, "Width to which R is certified (default: 1e-6)")
      ->check(width_of_interval());
  command->add_option("--classes", options->classes, "Classes of the models (.cla), for experiments that take them");
  command->add_flag("-q,--quick", options->quick, "Small: about a second for each experiment, and a gap of 1e-3");
  add_threads_option(*command, options->threads, "the answer is the same for any");
  command->footer(
      "Every R is certified. OUT/NAME.json holds all numbers; each picture has a CSV file beside it, and a gnuplot "
      "file\n"
      "if it is a curve. OUT/index.html shows all experiments in the folder. One line says how the outcome compares\n"
      "with the paper.\n"
      "Examples: rectilin experiment\n"
      "          rectilin experiment all\n"
      "          rectilin experiment 'fig15?steps=1000' --out pyramids");
  command->callback([options, &status, argc, argv] { status = experiment(*options, quoted_command_line(argc, argv)); });
}

}  // namespace rectilin::app
