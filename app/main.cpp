// rectilin: the command line. It parses options, calls the libraries and prints.
#include <exception>
#include <filesystem>

#include "commands.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/system_reason.h"
#include "rectilin/base/version.h"
#include "terminal.h"

int main(int argc, char** argv) {
  using namespace rectilin::app;
  clean_up_on_signals();
  CLI::App app(
      "How rectilinear is a 3D mesh?\n"
      "R(M) = 3 (max S/P - 2/3), S the surface area, P the sum of the areas projected on three orthogonal\n"
      "planes, over all rotations of the planes (Lian, Rosin and Sun, IJCV 2010). 1: all faces meet at right\n"
      "angles; near 0: like a sphere.\n");
  app.set_version_flag("--version", rectilin::version());
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.footer("Try: rectilin measure shape:pyramid\n     rectilin measure --help");

  int status = 0;
  add_measure_command(app, status);
  add_compare_command(app, status, argc, argv);
  add_evaluate_command(app, status, argc, argv);
  add_experiment_command(app, status, argc, argv);
  add_validate_command(app, status);
  add_suite_command(app, status);
  add_verify_command(app, status);
  add_pose_command(app, status);
  add_render_command(app, status);
  add_silhouette_command(app, status);
  add_convert_command(app, status);
  add_corpus_commands(app, status);
  add_describe_command(app, status);
  add_search_commands(app, status);
  add_duplicates_command(app, status);
#ifdef RECTILIN_HAS_SERVE
  add_serve_command(app, status);
#endif
  add_list_commands(app);

  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return "rectilin: " + rectilin::printable(e.what()) + " (see --help)\n";
  });
  try {
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
      // CLI11 prints help to standard output, with status 0, and error messages to standard error.
      if (app.exit(e) != 0) return 2;
    }
    check_output();
  } catch (const rectilin::ParameterError& e) {
    complain(e.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& e) {
    complain(e.path1().string() + ": " + rectilin::system_reason(e.code()));
    return 1;
  } catch (const std::exception& e) {
    complain(e.what());
    return 1;
  }
  return status;
}
