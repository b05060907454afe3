// rectilin convert: writes any mesh or shape to a file in another format.
#include <memory>

#include "commands.h"
#include "rectilin/mesh/source.h"
#include "terminal.h"

namespace rectilin::app {

void add_convert_command(CLI::App& app, int& status) {
  struct Options {
    std::string source, target;
    bool text = false, recentre = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("convert", "Write a mesh or a built-in shape to a file");
  command->add_option("source", options->source, "Mesh file or shape:NAME?key=value")->required();
  command->add_option("target", options->target, "File to write; .off, .obj, .ply or .stl")->required();
  command->add_flag("--text", options->text, "Text instead of binary, for .ply and .stl");
  command->add_flag("--recentre", options->recentre,
                    "Move the middle of the mesh to the origin, where the single precision of binary STL is finest");
  command->footer("Example: rectilin convert 'shape:blob?faces=100000' blob.ply");
  command->callback([options, &status] {
    const LoadedMesh loaded = load_mesh(options->source);
    const std::string note =
        write_mesh(options->target, loaded.mesh, {.binary = !options->text, .recentre = options->recentre});
    complain_of_loss(options->source, loaded.report);
    if (!note.empty()) complain(note);
    status = 0;
  });
}

}  // namespace rectilin::app
