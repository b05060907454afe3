// rectilin measure: R(M) and the pose of files and shapes.
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "commands.h"
#include "corpus_run.h"
#include "measure_printer.h"
#include "options.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/normals.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct MeasureCommand {
  std::vector<std::string> sources;
  std::vector<std::string> o;  ///< values of -o
  std::string optimizer = "certify";
  std::optional<double> gap;
  bool optima = false;
  std::string proof;
  std::string domain = "covering";
  std::uint64_t seed = 1;
  Budget budget = {};
  int threads = 0;
  bool normals = false;
  bool json = false;
  CorpusArguments corpus;
};

/// Reads the list of sources on standard input.
std::vector<std::string> listed_sources() {
  std::ostringstream list;
  if (std::cin.peek() != std::istream::traits_type::eof()) list << std::cin.rdbuf();
  return sources_in_list(list.view(), "standard input");
}

/// The options of measure() that the command line asks for.
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

/// Refuses to write a proof over a mesh.
void check_proof(const std::string& proof, const std::vector<std::string>& sources) {
  if (sources.size() > 1) throw ParameterError("--proof is for one mesh at a time");
  std::error_code ignored;  // if one of the two does not exist they are different files
  if (format_of_extension(proof) || std::filesystem::equivalent(proof, sources.front(), ignored))
    throw ParameterError("--proof " + proof + ": the proof would replace a mesh or look like one");
}

/// Takes the values of -o: an optimizer or, ending in .db, a store; both may be given.
void take_o(MeasureCommand& command) {
  bool has_optimizer = false;
  for (const std::string& value : command.o) {
    const bool is_store = is_store_name(value);
    if (is_store ? !command.corpus.store.empty() : has_optimizer)
      throw ParameterError(std::string("-o: more than one ") + (is_store ? "store" : "optimizer"));
    has_optimizer |= !is_store;
    (is_store ? command.corpus.store : command.optimizer) = value;
  }
}

/// The task of a store: everything that a result depends on.
corpus::Task corpus_task(const MeasureCommand& command) {
  const Budget& budget = command.budget;
  return {"measure",
          {{"optimizer", command.optimizer},
           {"gap", command.gap ? Json(*command.gap) : Json(nullptr)},
           {"optima", command.optima},
           {"domain", command.domain},
           {"seed", command.seed},
           {"evaluations", budget.limits_evaluations() ? Json(budget.evaluations) : Json(nullptr)}}};
}

/// The sources named on the command line and, for each '-', on standard input.
std::vector<std::string> named_sources(const std::vector<std::string>& named) {
  std::vector<std::string> given;
  for (const std::string& source : named) {
    if (source != "-") given.push_back(source);
    else
      for (const std::string& name : listed_sources()) given.push_back(name);
  }
  return given;
}

int run_into_store(const MeasureCommand& command) {
  if (command.json || !command.proof.empty()) throw ParameterError("--json and --proof cannot be used with a store");
  options_of(command);  // throws for wrong options before any workers are started
  const Budget& budget = command.budget;
  const auto seconds = budget.limits_seconds() ? std::optional(budget.seconds) : std::nullopt;
  return work_into_store(expand_sources(named_sources(command.sources)), corpus_task(command), command.corpus,
                         worker_options(command.corpus, seconds, command.threads));
}

/// Text that says how far a slow search is.
std::string state_of(const Evaluator& run) {
  std::string text = fixed(run.seconds(), 0) + " s, " + std::to_string(run.costs().evaluations()) + " evaluations";
  if (run.parts_bounded() > 0) text += ", " + std::to_string(run.parts_bounded()) + " boxes bounded";
  if (!run.has_incumbent()) return text;
  const double found = run.objective().merit(run.incumbent().value);
  text += ", R >= " + fixed(found, 6);
  if (run.lower_bound()) text += ", gap " + general(run.objective().merit(*run.lower_bound()) - found, 2);
  return text;
}

MeasuredMesh measure_mesh(const std::string& source, const rectilin::MeasureOptions& options) {
  const LoadedMesh loaded = load_mesh(source);
  MeasuredMesh measured{measure(loaded.mesh, options), loaded.report, {}};
  if (const auto& proof = measured.result.certificate)
    measured.proof = to_text(to_json(*proof, mesh_digest(loaded.mesh))) + '\n';
  return measured;
}

/// Measures a point cloud with normals.
MeasuredMesh measure_normals(const std::string& source, const rectilin::MeasureOptions& options) {
  const WeightedNormals cloud = read_normals(source);
  const ProjectedArea objective(area_vectors_of_normals(cloud.normals, cloud.weights));
  MeshReport report;
  report.vertices = cloud.points;
  report.nonfinite_vertices = cloud.dropped;
  return {measure(objective, options), report, {}};
}

int run(const MeasureCommand& command) {
  rectilin::MeasureOptions options = options_of(command);
  if (command.normals && !(command.proof.empty() && command.corpus.store.empty()))
    throw ParameterError("--normals does not go with --proof, which is about a mesh, nor with a store");
  if (!command.corpus.store.empty()) return run_into_store(command);
  command.corpus.check();
  const std::vector<std::string> sources = expand_folders(named_sources(command.sources));
  if (sources.empty()) throw MeshError("the list of files is empty");
  if (!command.proof.empty()) check_proof(command.proof, sources);
  options.run.stop = stop_on_interrupt();
  const auto limit = limit_threads(command.threads);

  MeasurePrinter printer(sources, command.json);
  Progress progress(sources.size());
  const auto measure_one = [&](std::size_t i) {
    rectilin::MeasureOptions own = options;
    own.run.on_progress = [&, i](const Evaluator& run) {
      progress.note(shortened(sources[i], 30) + ": " + state_of(run));
    };
    return command.normals ? measure_normals(sources[i], own) : measure_mesh(sources[i], own);
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
      ->add_option(
          "source", options->sources,
          "Mesh files (.off .obj .ply .stl .gltf .glb .3mf), folders and archives of them (zip, tar, 7z; a member "
          "is archive.zip::path/in/it.obj), lists (.txt, .csv), built-in shapes (shape:NAME?key=value, see "
          "'rectilin shapes'), or - for a list on standard input")
      ->required();
  command
      ->add_option("-o,--optimizer", options->o,
                   "Optimizer, with parameters: ga?population=100 (see 'rectilin optimizers'); or a store, FILE.db")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->default_str(options->optimizer);
  command->add_option("-g,--gap", options->gap, "Width to which R is certified (default: 1e-6)")
      ->check(width_of_interval());
  command
      ->add_option("-p,--proof", options->proof,
                   "File to write a proof of the bounds to (one mesh); 'rectilin verify' checks it")
      ->check([](const std::string& file) { return file.empty() ? "a proof needs a file name" : ""; });
  command->add_flag(
      "--normals", options->normals,
      "The sources are point clouds: PLY files with nx, ny, nz, and weight or area if they have it. R and "
      "the pose are those of their normals: the certified Manhattan frame");
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
  command
      ->add_option("--seconds", options->budget.seconds,
                   "Seconds at most, per mesh (default: no limit); with a store, reading included")
      ->check(positive_number());
  add_threads_option(*command, options->threads, "the answer is the same for any");
  add_corpus_options(*command, options->corpus, "-O,--out", "; with a store, like all that follows");
  command->add_flag("-j,--json", options->json, "One JSON object a line instead of the table");
  command->footer(
      "The angles printed are the paper's alpha, beta, gamma (eqs. 35-37) in degrees, of the rotation that takes\n"
      "the mesh to its best pose. A file that cannot be measured costs its own row and the exit status (1).\n"
      "R is that of the pose found; no pose has more than 'at most', where an optimizer proves it.\n"
      "Examples: rectilin measure chair.off\n"
      "          rectilin measure --json meshes/ > results.jsonl\n"
      "          rectilin measure --optimizer grid --domain zone 'shape:cylinder?sides=64'\n"
      "          rectilin measure abc.zip -o abc.db --seconds 60 --memory 4G");
  command->callback([options, &status] {
    take_o(*options);
    status = run(*options);
  });
}

}  // namespace rectilin::app
