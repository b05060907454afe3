// rectilin serve: a page in the browser to search a database with.
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/serve/serve.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

int serve_database(serve::ServeOptions options, int threads) {
  const auto limit = limit_threads(threads);
  options.worker_command = {std::filesystem::read_symlink("/proc/self/exe").string(), "serve-worker"};
  std::unique_ptr<Progress> progress;
  options.on_progress = [&](std::size_t done, std::size_t total, const std::string& text) {
    if (!progress) progress = std::make_unique<Progress>(total);
    progress->show(done, text);
  };
  const auto started = [&](const serve::Started& s) {
    progress.reset();
    if (!s.note.empty()) complain(s.note);
    std::cout << options.database << ": " << s.shapes << " shapes at " << s.url << " (Ctrl-C ends it)\n";
    if (!s.viewer)
      std::cout << "without 3D: three.js was not there when rectilin was built (it takes npm and a network)\n";
    std::cout << std::flush;
  };
  try {
    serve::serve(options, started, stop_on_interrupt());
  } catch (const Stopped&) {
    progress.reset();
    complain("stopped; what was built of the graph is kept: the same command goes on from here");
    return 1;
  }
  return 0;
}

}  // namespace

void add_serve_command(CLI::App& app, int& status) {
  struct Options {
    serve::ServeOptions serve;
    int threads = 0;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("serve", "Browse and search a database of shapes in a web browser");
  command->add_option("database", options->serve.database, "Database, made by 'rectilin index'")->required();
  command->add_option("-p,--port", options->serve.port, "Port; 0 for any that is free")->capture_default_str();
  command
      ->add_option("--address", options->serve.address,
                   "Address to listen on; 0.0.0.0 lets other machines in, who may then see all shapes")
      ->capture_default_str();
  command
      ->add_option("--host", options->serve.hosts,
                   "A name that browsers may use for this machine, besides localhost and addresses; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--upload", options->serve.upload_bytes, "Size of an uploaded file at most (500K, 1G)")
      ->transform(CLI::AsSizeValue(false))
      ->default_str("256M");
  command->add_flag("--approximate", options->serve.approximate,
                    "Search by a graph in DATABASE-graph, built when needed (a million shapes take ten minutes): some "
                    "milliseconds instead of 0.3 s for a million, but some of the nearest may be missed");
  add_threads_option(*command, options->threads, "for searches");
  command->footer(
      "The page browses the collection, searches by a member or by a file dropped on it, and turns shapes in 3D side "
      "by\nside. It needs no network. Only members of the database are served, and only while their files are as they "
      "were\nindexed; files that are sent are read in a process of their own and not kept on disk.\n"
      "Example: rectilin index parts/ -o parts.db; rectilin serve parts.db");
  command->callback([options, &status] { status = serve_database(options->serve, options->threads); });

  CLI::App* worker = app.add_subcommand("serve-worker", "");
  worker->group("");  // not shown in the help: the server runs it itself
  worker->callback([&status] { status = serve::run_mesh_worker(); });
}

}  // namespace rectilin::app
