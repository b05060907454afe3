// rectilin optimizers, poses, shapes, descriptors: lists of what there is, with every parameter.
#include <algorithm>
#include <iostream>

#include "commands.h"
#include "rectilin/mesh/shapes.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/pose/pose.h"
#include "rectilin/retrieval/descriptor.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

/// From `{"local": true, ...}`, the names of the flags that are true.
std::string words(const Json& flags) {
  std::string text;
  for (const auto& [name, value] : flags.items())
    if (value.get<bool>()) text += (text.empty() ? "" : ", ") + name;
  std::ranges::replace(text, '_', ' ');
  return text;
}

/// Prints a list. `capabilities(entry)` returns an object of flags, empty if there is nothing to tell.
template <class Entries, class Capabilities>
void list(const Entries& entries, bool json, Capabilities capabilities) {
  for (const auto& entry : entries) {
    const Json flags = capabilities(entry);
    if (json) {
      Json parameters = Json::array();
      for (const auto& p : entry.parameters)
        parameters.push_back({{"name", p.name}, {"default", p.value}, {"accepts", p.accepts}, {"help", p.help}});
      Json line = {{"name", entry.name}, {"help", entry.help}, {"parameters", parameters}};
      if (!flags.empty()) line["capabilities"] = flags;
      std::cout << to_text(line) << '\n';
      continue;
    }
    std::cout << entry.name << "\n    " << entry.help << '\n';
    if (!flags.empty()) std::cout << "    " << words(flags) << '\n';
    std::cout << settings_table(entry.parameters);
  }
}

template <class Get, class Capabilities>
void add_list(CLI::App& app, const std::string& name, const std::string& help, Get get, Capabilities capabilities) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(name, help);
  command->add_flag("-j,--json", *json, "One JSON object a line");
  command->callback([json, get, capabilities] { list(get(), *json, capabilities); });
}

}  // namespace

void add_list_commands(CLI::App& app) {
  add_list(
      app, "optimizers", "List the optimizers, what they can do and need, and their parameters",
      [] { return all_optimizers().entries(); },
      [](const Registry::Entry& entry) { return to_json(all_optimizers().make(entry.name)->capabilities()); });
  add_list(
      app, "poses", "List the methods of 'rectilin pose' and their parameters",
      [] { return pose::pose_methods().entries(); }, [](const auto&) { return Json::object(); });
  add_list(
      app, "shapes", "List the built-in shapes and their parameters", [] { return shape_table().entries(); },
      [](const Factory<Mesh>::Entry&) { return Json::object(); });
  add_list(
      app, "descriptors", "List the shape descriptors and their parameters",
      [] { return retrieval::descriptors().entries(); }, [](const auto&) { return Json::object(); });
}

}  // namespace rectilin::app
