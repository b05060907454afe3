// rectilin evaluate: how well descriptors find models of the same class as the query.
#include <cmath>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/evaluation/evaluation.h"
#include "rectilin/evaluation/tuning.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct EvaluateOptions {
  std::string folder, classes, out = "evaluation", tune;
  std::vector<std::string> descriptors, matrices, lfd;
  std::size_t budget = 1000, folds = 5;
  bool collection = false;
  std::uint64_t seed = 1;
  int threads = 0;
};

void print_scores(const evaluation::Evaluation& result) {
  const Table table({{"", 16}, {"NN", 5}, {"FT", 5}, {"ST", 5}, {"E", 5}, {"DCG", 5}, {"macro DCG", 9}, {"bytes", 6}});
  std::cout << table.header() << '\n';
  for (const evaluation::Result& r : result.results) {
    std::vector<std::string> row{r.contestant.label};
    for (const auto& m : retrieval::named_measures()) row.push_back(fixed(100 * r.scores.micro.*m.value, 1));
    row.push_back(fixed(100 * r.scores.macro.dcg, 1));
    row.push_back(r.bytes > 0 ? std::to_string(r.bytes) : "-");
    std::cout << table.row(row) << '\n';
  }
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

int evaluate(EvaluateOptions options, const std::string& command_line) {
  evaluation::EvaluationPlan plan;
  if (!options.folder.empty()) plan.folder = options.folder;
  plan.classes = options.classes;
  if (options.descriptors.empty() && options.matrices.empty() && options.lfd.empty() && options.tune.empty())
    options.descriptors = {"r, d1, d2, shd, gsmd, gsmd+0.3*shd+0.1*r"};
  plan.contestants = evaluation::parse_contestants(options.descriptors);
  plan.by_collection = options.collection;
  using Kind = evaluation::Contestant::Kind;
  evaluation::add_foreign(plan.contestants, options.matrices, Kind::kMatrix);
  evaluation::add_foreign(plan.contestants, options.lfd, Kind::kLfdFiles);
  evaluation::TuningPlan tuning{options.tune, options.budget, options.folds, options.seed};
  if (!options.tune.empty()) evaluation::add_terms(plan.contestants, tuning);

  const auto limit = limit_threads(options.threads);
  report::PictureTroubles troubles;
  evaluation::Evaluation result;
  evaluation::TuningOutcome tuned;
  {
    std::unique_ptr<Progress> progress;
    evaluation::EvaluationSettings settings;
    settings.stop = stop_on_interrupt();
    settings.command_line = command_line;
    settings.on_progress = [&](std::size_t done, std::size_t total, double left, const std::string& text) {
      if (!progress) progress = std::make_unique<Progress>(total);
      progress->show(done, time_left(left) + text);
    };
    result = evaluation::run_evaluation(plan, options.out, settings, troubles);
    if (result.complete && !options.tune.empty())
      tuned = evaluation::tune_composite(tuning, result, options.out, settings);
  }
  for (const std::string& error : result.errors) complain(error);
  for (const std::string& loss : result.losses) complain(loss);
  if (!result.complete || (!options.tune.empty() && !tuned.complete)) {
    complain("stopped; nothing finished is lost: the same command goes on from here");
    return 1;
  }
  if (!result.missing.empty())
    complain("no mesh file for " + std::to_string(result.missing.size()) + " models: " + listed(result.missing));
  if (!result.empty_classes.empty()) complain("empty classes: " + listed(result.empty_classes));
  if (!result.small_classes.empty())
    complain("classes of one or two models, which are in no mean: " + listed(result.small_classes));
  for (const std::string& trouble : troubles.lines) complain(trouble);
  print_scores(result);
  for (const std::string& line : tuned.lines) std::cout << line << '\n';
  std::cout << options.out << "/index.html\n";
  return result.errors.empty() && !troubles.failed ? 0 : 1;
}

}  // namespace

void add_evaluate_command(CLI::App& app, int& status, int argc, const char* const* argv) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command = app.add_subcommand("evaluate", "Score shape descriptors on a collection with classes");
  command->add_option("folder", options->folder, "Folder of meshes: model X is X.off or mX.off, in it or below");
  command->add_option("-c,--classes", options->classes, "Classification, a .cla file of the Princeton Shape Benchmark")
      ->required();
  command
      ->add_option(
          "-d,--descriptors", options->descriptors,
          "Descriptors separated by commas or blanks; may be repeated. Each as 'rectilin descriptors' shows it, "
          "with parameters (gsmd?views=18) or as a weighted sum (gsmd+0.3*shd+0.1*r), or @FILE with tuned "
          "weights. NAME= in front gives it another name. Default: a choice")
      ->allow_extra_args(false);
  command
      ->add_option("-m,--matrix", options->matrices,
                   "Distances somebody else computed, [NAME=]FILE.matrix: single precision, row by row, of all models "
                   "or of those that have a file; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--lfd", options->lfd,
          "Signatures by the light field descriptor's own program, [NAME=]FOLDER with X.art, .fd, .cir and "
          ".ecc (or mX.art ...) of each model; 'rectilin describe -d lfd:ntu' writes such, too; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--collection", options->collection,
                    "Each a second time, as LABEL@collection, ranked by diffusion through all models, which looks at "
                    "them all at once, but not at their classes");
  command->add_option("--tune", options->tune,
                      "Tune the weights of such a sum (gsmd+shd+r) for DCG, cross-validated over classes; they go to "
                      "OUT/weights.json");
  command->add_option("-b,--budget", options->budget, "Evaluations of each search for weights")
      ->check(count())
      ->capture_default_str();
  command->add_option("--folds", options->folds, "Parts that classes are divided into to validate the weights")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command->add_option("-s,--seed", options->seed, "Seed of the searches and folds")
      ->check(seed())
      ->capture_default_str();
  command->add_option("-O,--out", options->out, "Folder for everything")->capture_default_str();
  add_threads_option(*command, options->threads, "the scores are the same for any");
  command->footer(
      "Every model is ranked against all others; scores are those of the Princeton Shape Benchmark, in percent. OUT "
      "gets\n"
      "index.html, summary.json, tables, and the distances as OUT/matrices/NAME.matrix. Signatures are kept in\n"
      "OUT/features: after Ctrl-C (exit status 1) the same command goes on. Models without a file are named and left\n"
      "out; a mesh that fails costs the exit status, too.\n"
      "Examples: rectilin evaluate psb/ --classes train.cla --descriptors d2,shd,gsmd --out psb-train\n"
      "          rectilin evaluate psb/ -c train.cla -d 'fine=gsmd?views=258 coarse=gsmd?views=6'\n"
      "          rectilin evaluate -c test.cla --matrix theirs.matrix");
  command->callback([options, &status, argc, argv] { status = evaluate(*options, quoted_command_line(argc, argv)); });
}

}  // namespace rectilin::app
