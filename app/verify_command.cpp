// rectilin verify: checks a proof of R(M).
#include <iostream>
#include <memory>

#include "commands.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/source.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

int verify(const std::string& proof, const std::string& source) {
  const std::string text = read_whole_file(proof);
  const LoadedMesh loaded = load_mesh(source);
  complain_of_loss(source, loaded.report);
  const Verdict verdict = verify_certificate(text, loaded.mesh);
  if (!verdict.accepted) {
    std::cout << "refused: " << verdict.reason << '\n';
    return 1;
  }
  std::cout << "accepted: R is between " << fixed(verdict.lower, 10) << " and " << fixed(verdict.upper, 10) << " ("
            << verdict.leaves << " leaves, " << verdict.cuts << " cuts)\n";
  return 0;
}

}  // namespace

void add_verify_command(CLI::App& app, int& status) {
  struct Options {
    std::string proof, source;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("verify", "Check a proof written by 'measure --proof'");
  command->add_option("proof", options->proof, "The proof")->required();
  command->add_option("source", options->source, "The mesh: a file or shape:NAME?key=value")->required();
  command->footer("Example: rectilin measure --proof chair.json chair.off && rectilin verify chair.json chair.off");
  command->callback([options, &status] { status = verify(options->proof, options->source); });
}

}  // namespace rectilin::app
