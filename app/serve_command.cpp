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
  serve::serve(
      options,
      [&](const serve::Started& started) {
        std::cout << options.database << ": " << started.shapes << " shapes at " << started.url
                  << " (Ctrl-C ends it)\n";
        if (!started.viewer)
          std::cout << "without 3D: three.js was not there when rectilin was built (it takes npm and a network)\n";
        std::cout << std::flush;
      },
      stop_on_interrupt());
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
