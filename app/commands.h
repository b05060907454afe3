// The subcommands of `rectilin`. Each function adds its options to the parser, and a callback that does the work and
// sets `status` to the exit status: 0 for success, 1 if some input failed.
#pragma once

#include <CLI/CLI.hpp>

namespace rectilin::app {

void add_measure_command(CLI::App& app, int& status);
/// These commands record the command line in the results, so they get it.
void add_compare_command(CLI::App& app, int& status, int argc, const char* const* argv);
void add_evaluate_command(CLI::App& app, int& status, int argc, const char* const* argv);
void add_experiment_command(CLI::App& app, int& status, int argc, const char* const* argv);
void add_validate_command(CLI::App& app, int& status);
void add_suite_command(CLI::App& app, int& status);
void add_verify_command(CLI::App& app, int& status);
void add_render_command(CLI::App& app, int& status);
void add_silhouette_command(CLI::App& app, int& status);
void add_convert_command(CLI::App& app, int& status);
void add_pose_command(CLI::App& app, int& status);
void add_list_commands(CLI::App& app);
void add_corpus_commands(CLI::App& app, int& status);
void add_describe_command(CLI::App& app, int& status);
void add_search_commands(CLI::App& app, int& status);
void add_duplicates_command(CLI::App& app, int& status);
void add_serve_command(CLI::App& app, int& status);  ///< only in builds with the house serve

}  // namespace rectilin::app
