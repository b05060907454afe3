// rectilin verify: is a proof of R(M) right?
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include "commands.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/source.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

int verify(const std::string& proof, const std::string& source) {
  std::ifstream in(proof, std::ios::binary);
  std::ostringstream text;
  if (!(text << in.rdbuf())) throw MeshError(proof + ": cannot be read");
  const Verdict verdict = verify_certificate(text.str(), load_mesh(source).mesh);
  if (!verdict.accepted) {
    std::cout << "refused: " << verdict.reason << '\n';
    return 1;
  }
  std::cout << "accepted: R is between " << fixed(verdict.lower, 10) << " and " << fixed(verdict.upper, 10) << " ("
            << verdict.leaves << " leaves, " << verdict.directions << " directions)\n";
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
