// rectilin optimizers, rectilin shapes: what there is, with every parameter.
#include <iostream>

#include "commands.h"
#include "rectilin/measure/shapes.h"
#include "rectilin/optim/registry.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

template <class Entries>
void list(const Entries& entries, bool json) {
  for (const auto& entry : entries) {
    if (json) {
      Json parameters = Json::array();
      for (const auto& p : entry.parameters)
        parameters.push_back({{"name", p.name}, {"default", p.value}, {"accepts", p.accepts}, {"help", p.help}});
      std::cout << Json{{"name", entry.name}, {"help", entry.help}, {"parameters", parameters}}.dump() << '\n';
      continue;
    }
    std::cout << entry.name << "\n    " << entry.help << '\n' << settings_table(entry.parameters);
  }
}

template <class Get>
void add_list(CLI::App& app, const std::string& name, const std::string& help, Get get) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(name, help);
  command->add_flag("-j,--json", *json, "One JSON object a line");
  command->callback([json, get] { list(get(), *json); });
}

}  // namespace

void add_list_commands(CLI::App& app) {
  add_list(app, "optimizers", "List the optimizers and their parameters",
           [] { return builtin_optimizers().entries(); });
  add_list(app, "shapes", "List the built-in shapes and their parameters", [] { return list_shapes(); });
}

}  // namespace rectilin::app
