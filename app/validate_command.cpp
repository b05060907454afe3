// rectilin validate: tests the paper's claims.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/source.h"
#include "rectilin/optim/run_record.h"
#include "rectilin/paper/claims.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct ValidateOptions {
  std::vector<std::string> sources;
  paper::ValidationSettings settings;
  std::string out = "counterexamples";
  int threads = 0;
  bool json = false, markdown = false, list = false;
};

/// Writes the mesh and the rotation of a claim's decisive finding; returns the path of the mesh.
std::string write_counterexample(const paper::ClaimResult& result, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const std::string mesh = (folder / (result.claim->id + ".off")).string();
  write_mesh(mesh, result.decisive.mesh ? *result.decisive.mesh : load_mesh(result.decisive.where).mesh);
  const Eigen::Vector3d angles = euler_from_rotation(result.decisive.rotation);
  const std::string file = (folder / (result.claim->id + ".json")).string();
  const Json finding = {{"claim", result.claim->id},
                        {"where", result.decisive.where},
                        {"margin", result.decisive.margin},
                        {"rotation", to_json(result.decisive.rotation)},
                        {"angles", {angles[0], angles[1], angles[2]}},
                        {"note", result.decisive.note}};
  write_whole_file(file, to_text(finding, 2) + '\n');
  return mesh;
}

/// Is there a mesh to show? Not for claims about rotations or angles alone.
bool has_mesh(const paper::Finding& finding) {
  return finding.mesh || finding.where.starts_with("shape:") || std::filesystem::exists(finding.where);
}

Json to_json(const paper::ClaimResult& result, const std::string& mesh, const std::vector<std::string>& losses) {
  Json json = {{"claim", result.claim->id},
               {"source", result.claim->source},
               {"expected", result.claim->should_hold ? "holds" : "fails"},
               {"verdict", to_string(result.verdict)},
               {"margin", nullptr},
               {"tolerance", result.claim->tolerance},
               {"tested", result.tested},
               {"failed", result.failed},
               {"where", result.decisive.where},
               {"note", result.decisive.note},
               {"counterexample", nullptr},
               {"left_out", losses}};
  if (result.tested > 0) json["margin"] = result.decisive.margin;
  if (result.verdict == paper::ClaimVerdict::kFails) {
    json["counterexample"] = {{"mesh", mesh.empty() ? Json(nullptr) : Json(mesh)},
                              {"rotation", to_json(result.decisive.rotation)}};
  }
  return json;
}

void print_table(const paper::Validation& validation) {
  const Table table({{"claim", 18},
                     {"expected", 8},
                     {"verdict", 17},
                     {"margin", 11},
                     {"tolerance", 9},
                     {"tested", 6},
                     {"failed", 6}});
  std::cout << table.header() << "  decided by\n";
  for (const paper::ClaimResult& result : validation.results) {
    const bool tested = result.tested > 0;
    std::cout << table.row({result.claim->id, result.claim->should_hold ? "holds" : "fails",
                            std::string(to_string(result.verdict)), tested ? general(result.decisive.margin, 4) : "-",
                            general(result.claim->tolerance, 2), std::to_string(result.tested),
                            std::to_string(result.failed)})
              << "  " << printable(result.decisive.where);
    if (!result.decisive.note.empty()) std::cout << " (" << printable(result.decisive.note) << ")";
    std::cout << '\n';
  }
}

void print_list() {
  for (const paper::Claim& claim : paper::all_claims()) {
    std::cout << claim.id << "  [" << claim.source << "]\n    " << claim.statement << "\n    Tested: " << claim.test
              << "\n    Tolerance: " << general(claim.tolerance, 2) << " (" << claim.why << ")\n";
    if (!claim.should_hold) std::cout << "    Expected to fail. " << claim.remark << '\n';
    else if (!claim.remark.empty()) std::cout << "    " << claim.remark << '\n';
  }
}

int run_validation(ValidateOptions options) {
  if (options.list || options.markdown) {
    if (options.markdown) std::cout << paper::claims_markdown();
    else print_list();
    return 0;
  }
  const auto limit = limit_threads(options.threads);

  paper::Validation validation;
  {
    std::unique_ptr<Progress> progress;
    options.settings.stop = stop_on_interrupt();
    options.settings.on_progress = [&](std::size_t done, std::size_t total, const std::string& what) {
      if (!progress) progress = std::make_unique<Progress>(total);
      progress->show(done, what);
    };
    validation = paper::validate(options.sources, options.settings);
  }
  std::vector<std::string> errors = validation.errors;
  Json list = Json::array();
  for (const paper::ClaimResult& result : validation.results) {
    std::string mesh;
    try {
      if (result.verdict == paper::ClaimVerdict::kFails && has_mesh(result.decisive))
        mesh = write_counterexample(result, options.out);
    } catch (const std::exception& e) {
      errors.push_back(e.what());  // go on: the verdicts matter more than this file
    }
    list.push_back(to_json(result, mesh, validation.losses));
  }
  for (const std::string& error : errors) complain(error);
  for (const std::string& loss : validation.losses) complain(loss);
  if (options.json) std::cout << to_text(list, 2) << '\n';
  else print_table(validation);

  for (const paper::ClaimResult& result : validation.results)
    if (result.claim->should_hold && result.verdict == paper::ClaimVerdict::kFails)
      complain(result.claim->id + " fails: " + result.decisive.where);
  if (!validation.complete) complain("stopped: the verdicts rest on what was tested so far");
  return validation.as_expected() && errors.empty() && validation.complete ? 0 : 1;
}

}  // namespace

void add_validate_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand("validate", "Test the paper's claims");
  command->add_option("source", options->sources,
                      "Mesh files, folders of them, built-in shapes (shape:NAME?key=value). Default: some shapes");
  command->add_option("-c,--claims", options->settings.claims, "Claims to test, separated by commas. Default: all")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("-s,--seed", options->settings.seed, "Seed of the random rotations and runs")
      ->check(seed())
      ->capture_default_str();
  command->add_option("--collection", options->settings.collection,
                      "Folder of models, for the claims about retrieval, which otherwise are not tested");
  command->add_option("--classes", options->settings.classes,
                      "Their classification, a .cla file of the Princeton Shape Benchmark");
  command->add_option("--cache", options->settings.cache, "Folder in which their signatures are kept from run to run");
  command
      ->add_option("-O,--out", options->out,
                   "Folder for counterexamples (a mesh and a rotation), made if there are any")
      ->capture_default_str();
  add_threads_option(*command, options->threads, "the verdicts are the same for any");
  command->add_flag("-j,--json", options->json, "A list of JSON objects instead of the table");
  command->add_flag("-m,--markdown", options->markdown,
                    "Print the ledger of claims as a table in Markdown; test nothing");
  command->add_flag("-l,--list", options->list, "Print the claims and how they are tested; test nothing");
  command->footer(
      "A margin is the room between what was seen and what the claim allows. A claim holds if the worst margin is "
      "zero\n"
      "within the tolerance, holds with margin above that, and fails below. Exit status 1: a claim that should hold\n"
      "failed, or a mesh could not be read.\n"
      "Examples: rectilin validate\n"
      "          rectilin validate --claims eq-28,eq-28-zone meshes/ --out wrong\n"
      "          rectilin validate --json chair.off\n"
      "          rectilin validate -c r-improves --collection psb/ --classes train.cla --cache features");
  command->callback([options, &status] { status = run_validation(*options); });
}

}  // namespace rectilin::app
