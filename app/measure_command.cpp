// rectilin measure: from files and shapes to R(M).
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "commands.h"
#include "measure_row.h"
#include "options.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct MeasureOptions {
  std::vector<std::string> sources;
  std::string optimizer = Certify::kName;
  std::optional<double> gap;
  bool optima = false;
  std::string proof;
  std::string domain = "covering";
  std::uint64_t seed = 1;
  Budget budget = {};
  int threads = 0;
  bool json = false;
};

/// The sources in the list on standard input.
std::vector<std::string> listed_sources() {
  std::ostringstream list;
  if (std::cin.peek() != std::istream::traits_type::eof()) list << std::cin.rdbuf();
  return sources_in_list(list.view(), "standard input");
}

/// The optimizer asked for, with the options that only Certify has.
std::unique_ptr<Optimizer> make_optimizer(const MeasureOptions& options) {
  if (!options.gap && !options.optima && options.proof.empty()) return all_optimizers().make(options.optimizer);
  Spec spec = Spec::parse(options.optimizer);
  if (spec.name != Certify::kName)
    throw ParameterError("--gap, --optima and --proof need the optimizer " + std::string(Certify::kName));
  if (options.gap) spec.settings["gap"] = *options.gap;
  if (options.optima) spec.settings["optima"] = true;
  return all_optimizers().make(spec.name, spec.settings);
}

/// A proof must not take the place of a mesh.
void check_proof(const std::string& proof, const std::vector<std::string>& sources) {
  if (sources.size() > 1) throw ParameterError("--proof is for one mesh at a time");
  std::error_code ignored;  // if one of them does not exist they are different
  if (format_of_extension(proof) || std::filesystem::equivalent(proof, sources.front(), ignored))
    throw ParameterError("--proof " + proof + ": the proof would be written over a mesh, or look like one");
}

int measure(const MeasureOptions& options) {
  const auto optimizer = make_optimizer(options);
  RunSettings settings;
  settings.budget = options.budget;
  settings.seed = options.seed;
  settings.domain = &domain_by_name(options.domain);

  std::vector<std::string> given;
  for (const std::string& source : options.sources) {
    if (source != "-") given.push_back(source);
    else
      for (const std::string& name : listed_sources()) given.push_back(name);
  }
  const std::vector<std::string> sources = expand_folders(given);
  if (sources.empty()) throw MeshError("the list of files is empty");
  if (!options.proof.empty()) check_proof(options.proof, sources);
  settings.stop = stop_on_interrupt();

  const auto limit = limit_threads(options.threads);
  const std::size_t at_once = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);

  // Several files at once, rows in order. Isolated, because a thread that waits for the loops inside one
  // file must not pick up another file and charge its time to the first.
  Printer printer(sources, options.json);
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& flow) {
    if (next < sources.size() && !settings.stop.stop_requested()) return next++;
    flow.stop();
    return next;
  };
  const auto measure_one = [&](std::size_t i) {
    auto row = std::make_shared<Row>();
    tbb::this_task_arena::isolate(
        [&] { *row = measure_source(sources[i], *optimizer, settings, !options.proof.empty()); });
    return row;
  };
  const auto print = [&](const std::shared_ptr<Row>& row) {
    printer.print(*row);
    if (!row->proof.empty()) write_whole_file(options.proof, row->proof);
  };
  using RowPointer = std::shared_ptr<Row>;
  tbb::parallel_pipeline(at_once,
                         tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
                             tbb::make_filter<std::size_t, RowPointer>(tbb::filter_mode::parallel, measure_one) &
                             tbb::make_filter<RowPointer, void>(tbb::filter_mode::serial_in_order, print));
  if (next < sources.size()) complain("stopped: " + std::to_string(sources.size() - next) + " meshes are not measured");
  return printer.failed() > 0 || settings.stop.stop_requested() ? 1 : 0;
}

}  // namespace

void add_measure_command(CLI::App& app, int& status) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand("measure", "Measure R(M) and the pose of meshes");
  command
      ->add_option("source", options->sources,
                   "Mesh files (.off .obj .ply .stl), folders of them, built-in shapes (shape:NAME?key=value, "
                   "see 'rectilin shapes'), or - for a list on standard input")
      ->required();
  command
      ->add_option("-o,--optimizer", options->optimizer,
                   "Optimizer, with parameters: ga?population=100 (see 'rectilin optimizers')")
      ->capture_default_str();
  command->add_option("-g,--gap", options->gap, "Width to which certify encloses R (default: 1e-6)")->check(width());
  command
      ->add_option("-p,--proof", options->proof,
                   "File for a proof of the bounds, one mesh; 'rectilin verify' checks it")
      ->check([](const std::string& file) { return file.empty() ? "a proof needs a file's name" : ""; });
  command->add_flag("--optima", options->optima, "Find all poses within the gap (shown with --json)");
  command
      ->add_option("-d,--domain", options->domain,
                   "Box that optimizers on a domain search: paper ([0,90]^3 degrees, three quarters of all "
                   "orientations), covering ([0,180]x[0,90]^2, all), zone (Rodrigues cube, all)")
      ->check(CLI::IsMember({"paper", "covering", "zone"}))
      ->capture_default_str();
  command->add_option("-s,--seed", options->seed, "Seed of the random numbers")->check(seed())->capture_default_str();
  command->add_option("-b,--budget", options->budget.evaluations, "Evaluations at most, per mesh (default: no limit)")
      ->check(count());
  command->add_option("--seconds", options->budget.seconds, "Seconds at most, per mesh (default: no limit)")
      ->check(positive_number());
  add_threads_option(*command, options->threads, "the answer is the same for any");
  command->add_flag("-j,--json", options->json, "One JSON object a line instead of the table");
  command->footer(
      "The angles printed are the paper's alpha, beta, gamma (eqs. 35-37) in degrees, of the rotation that takes\n"
      "the mesh to its best pose. A file that cannot be measured costs its own row and the exit status (1).\n"
      "R is that of the pose found; no pose has more than 'at most', where an optimizer proves it.\n"
      "Examples: rectilin measure chair.off\n"
      "          rectilin measure --json meshes/ > results.jsonl\n"
      "          rectilin measure --optimizer grid --domain zone 'shape:cylinder?sides=64'");
  command->callback([options, &status] { status = measure(*options); });
}

}  // namespace rectilin::app
