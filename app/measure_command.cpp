// rectilin measure: from files and shapes to R(M).
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "commands.h"
#include "measure_printer.h"
#include "options.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct MeasureCommand {
  std::vector<std::string> sources;
  std::string optimizer = "certify";
  std::optional<double> gap;
  bool optima = false;
  std::string proof;
  std::string domain = "covering";
  std::uint64_t seed = 1;
  Budget budget = {};
  int threads = 0;
  bool json = false;
};

std::vector<std::string> lines_of(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// What to do with each mesh.
rectilin::MeasureOptions options_of(const MeasureCommand& command) {
  rectilin::MeasureOptions options = measure_options(command.optimizer, all_optimizers());
  if ((command.gap || command.optima || !command.proof.empty()) && options.optimizer)
    throw ParameterError("--gap, --optima and --proof need the optimizer certify");
  if (command.gap) options.certify.gap = *command.gap;
  if (command.optima) options.certify.optima = true;
  options.certificate = !command.proof.empty();
  options.run.budget = command.budget;
  options.run.seed = command.seed;
  options.run.domain = &domain_by_name(command.domain);
  return options;
}

/// A proof must not take the place of a mesh.
void check_proof(const std::string& proof, const std::vector<std::string>& sources) {
  if (sources.size() > 1) throw ParameterError("--proof is for one mesh at a time");
  std::error_code ignored;  // if one of them does not exist they are different
  if (format_of_extension(proof) || std::filesystem::equivalent(proof, sources.front(), ignored))
    throw ParameterError("--proof " + proof + ": the proof would be written over a mesh, or look like one");
}

/// The sources named on the command line and, for each '-', on standard input; folders opened.
std::vector<std::string> all_sources(const std::vector<std::string>& named) {
  std::vector<std::string> given;
  for (const std::string& source : named) {
    if (source != "-") given.push_back(source);
    else
      for (const std::string& line : lines_of(std::cin)) given.push_back(line);
  }
  std::vector<std::string> sources = expand_folders(given);
  if (sources.empty()) throw MeshError("the list of files is empty");
  return sources;
}

/// How far a search is that takes its time.
std::string state_of(const Evaluator& run) {
  std::string text = fixed(run.seconds(), 0) + " s, " + std::to_string(run.costs().evaluations()) + " evaluations";
  if (!run.has_incumbent()) return text;
  const double found = run.objective().merit(run.incumbent().value);
  text += ", R >= " + fixed(found, 6);
  if (run.lower_bound()) text += ", gap " + general(run.objective().merit(*run.lower_bound()) - found, 2);
  return text;
}

int run(const MeasureCommand& command) {
  rectilin::MeasureOptions options = options_of(command);
  const std::vector<std::string> sources = all_sources(command.sources);
  if (!command.proof.empty()) check_proof(command.proof, sources);
  options.run.stop = stop_on_interrupt();
  const auto limit = limit_threads(command.threads);

  MeasurePrinter printer(sources, command.json);
  Progress progress(sources.size());
  const auto measure_one = [&](std::size_t i) {
    rectilin::MeasureOptions own = options;
    own.run.on_progress = [&, i](const Evaluator& run) { progress.note(sources[i] + ": " + state_of(run)); };
    const LoadedMesh loaded = load_mesh(sources[i]);
    MeasuredMesh measured{measure(loaded.mesh, own), loaded.report, {}};
    if (const auto& proof = measured.result.certificate)
      measured.proof = to_text(to_json(*proof, mesh_digest(loaded.mesh))) + '\n';
    return measured;
  };
  const auto print = [&](std::size_t i, Outcome<MeasuredMesh>&& row) {
    progress.clear();
    printer.print(sources[i], row);
    if (row.value && !row.value->proof.empty()) write_whole_file(command.proof, row.value->proof);
  };
  const std::size_t done = for_each_in_order<MeasuredMesh>(sources, measure_one, print,
                                                           {.stop = options.run.stop, .on_progress = progress.shown()});
  progress.clear();
  if (done < sources.size()) complain("stopped: " + std::to_string(sources.size() - done) + " meshes are not measured");
  return printer.failed() > 0 || options.run.stop.stop_requested() ? 1 : 0;
}

}  // namespace

void add_measure_command(CLI::App& app, int& status) {
  auto options = std::make_shared<MeasureCommand>();
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
  command->add_option("-p,--proof", options->proof,
                      "File for a proof of the bounds, one mesh; 'rectilin verify' checks it");
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
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace rectilin::app
