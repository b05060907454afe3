// rectilin suite: fixed problems for programs in any language, whose results can be added to the page of a comparison.
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/report.h"
#include "rectilin/laboratory/suite.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct SuiteOptions {
  std::vector<std::string> what;
  std::string out;
  std::string traces, into;
  double gap = 1e-9;
  int threads = 0;
};

/// The suite that is meant: a suite's name, or meshes.
laboratory::Suite chosen(const std::vector<std::string>& what) {
  for (const laboratory::Suite& suite : laboratory::suites())
    if (what.size() == 1 && what.front() == suite.name) return suite;
  return laboratory::suite_of(what);
}

int list_suites() {
  for (const laboratory::Suite& suite : laboratory::suites()) {
    std::cout << suite.name << "  " << suite.help << '\n';
    for (const laboratory::SuiteProblem& problem : suite.problems)
      std::cout << "    " << problem.name << "  " << problem.landscape << "\n        " << problem.source << '\n';
  }
  return 0;
}

int export_problems(const laboratory::Suite& suite, const SuiteOptions& options) {
  const auto limit = limit_threads(options.threads);
  Progress progress(suite.problems.size());
  const std::vector<std::string> losses = laboratory::export_suite(
      suite, options.out, options.gap, {.stop = stop_on_interrupt(), .on_progress = progress.shown()});
  progress.clear();
  for (const std::string& loss : losses) complain(loss);
  std::cout << printable(options.out) << "/suite.json\n";
  return 0;
}

int read_traces(const SuiteOptions& options) {
  const std::size_t runs = laboratory::add_foreign_runs(options.into, read_whole_file(options.traces), options.traces);
  for (const std::string& trouble : laboratory::write_report(options.into).lines) complain(trouble);
  std::cout << runs << " runs read: " << printable(options.into) << "/index.html\n";
  return 0;
}

int run(const SuiteOptions& options) {
  if (options.traces.empty() != options.into.empty())
    throw ParameterError("--traces FILE and --into FOLDER go together");
  if (!options.traces.empty()) return read_traces(options);
  if (options.what.empty()) return list_suites();
  const laboratory::Suite suite = chosen(options.what);
  if (!options.out.empty()) return export_problems(suite, options);
  for (const laboratory::SuiteProblem& problem : suite.problems) std::cout << printable(problem.source) << '\n';
  return 0;
}

}  // namespace

void add_suite_command(CLI::App& app, int& status) {
  auto options = std::make_shared<SuiteOptions>();
  CLI::App* command = app.add_subcommand("suite", "Problems with certified optima, for programs in any language");
  command->add_option("suite", options->what, "A suite's name, or meshes of your own; none: the list of suites");
  command->add_option("-O,--out", options->out, "Folder for the problems as JSON; else their sources are printed");
  command->add_option("-g,--gap", options->gap, "Width to which optima are enclosed")
      ->check(width_of_interval())
      ->capture_default_str();
  command->add_option("--traces", options->traces, "Runs of another program, one JSON object a line");
  command->add_option("--into", options->into, "Folder of the comparison whose page is to show them");
  add_threads_option(*command, options->threads, "the problems are the same for any");
  command->footer(
      "A problem's file holds area vectors v, the best rotation known and proved bounds. A program minimises the sum "
      "of\n"
      "|R v|_1 over rotations R; a line of its results is {\"problem\": \"pyramid\", \"optimizer\": \"mine\", \"run\": "
      "0,\n"
      "\"evaluations\": [1, 7], \"value\": [1.3, 1.2], \"rotation\": [[...], [...], [...]]}.\n"
      "Examples: rectilin suite landscapes-1 -O problems\n"
      "          rectilin compare $(rectilin suite landscapes-1) -o ga,multistart -O out\n"
      "          rectilin suite --traces mine.jsonl --into out");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace rectilin::app
