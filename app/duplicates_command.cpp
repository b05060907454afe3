// rectilin duplicates: finds files of a database that hold the same shape.
#include <cmath>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/search/duplicates.h"
#include "rectilin/search/page.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct DuplicatesOptions {
  std::string database, page;
  search::DuplicateOptions settings;
  bool json = false;
  int threads = 0;
};

Json evidence_json(const search::DuplicateEvidence& e, const search::Duplicates& found) {
  const auto interval = [&](std::size_t member) {  // certified to 1e-6, see Model::rectilinearity()
    const double r = found.members[member].rectilinearity;
    return Json::array({r, std::min(1.0, r + 1e-6)});
  };
  return {{"first", found.members[e.first].name},
          {"second", found.members[e.second].name},
          {"same_bytes", e.same_bytes},
          {"mirrored", e.mirrored},
          {"descriptor_distance", e.descriptor_distance},
          {"surface_distance", e.surface_distance},
          {"scale", e.scale},
          {"rectilinearity_first", interval(e.first)},
          {"rectilinearity_second", interval(e.second)}};
}

void print_groups(const search::Duplicates& found, bool json) {
  std::size_t number = 0;
  for (const search::DuplicateGroup& group : found.groups) {
    if (json) {
      Json members = Json::array(), evidence = Json::array();
      for (std::size_t k = 0; k < group.members.size(); ++k)
        members.push_back({{"name", found.members[group.members[k]].name},
                           {"source", found.members[group.members[k]].source},
                           {"mirrored", static_cast<bool>(group.mirrored[k])}});
      for (const search::DuplicateEvidence& e : group.evidence) evidence.push_back(evidence_json(e, found));
      std::cout << to_text(Json{{"members", members}, {"evidence", evidence}}) << '\n';
      continue;
    }
    std::cout << "group " << ++number << ", " << group.members.size() << " files\n";
    for (std::size_t k = 0; k < group.members.size(); ++k)
      std::cout << "  " << printable(found.members[group.members[k]].name)
                << (group.mirrored[k] ? "  (mirror image of the first)" : "") << '\n';
    for (const search::DuplicateEvidence& e : group.evidence) {
      std::cout << "    " << printable(found.members[e.first].name) << " ~ " << printable(found.members[e.second].name)
                << ": ";
      if (e.same_bytes) {
        std::cout << "same bytes\n";
        continue;
      }
      std::cout << "surfaces " << general(e.surface_distance, 2) << " radii apart"
                << (e.mirrored ? " when mirrored" : "") << ", scale " << general(e.scale, 5) << ", R "
                << fixed(found.members[e.first].rectilinearity, 6) << " and "
                << fixed(found.members[e.second].rectilinearity, 6) << '\n';
    }
  }
  if (!json)
    std::cout << found.groups.size() << " groups in " << found.members.size() << " shapes, " << found.pairs_looked_at
              << " pairs looked at\n";
}

void write_page(const std::string& file, const search::Duplicates& found) {
  std::vector<search::PageSection> sections;
  for (const search::DuplicateGroup& group : found.groups) {
    search::PageSection section{"Group " + std::to_string(sections.size() + 1), {}};
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      const search::Member& m = found.members[group.members[k]];
      section.pictures.push_back(
          {m.name, m.source, group.mirrored[k] ? "mirrored" : "R " + fixed(m.rectilinearity, 4)});
    }
    sections.push_back(std::move(section));
  }
  write_whole_file(file, search::picture_page("Duplicates",
                                              std::to_string(found.groups.size()) +
                                                  " groups of files that are one "
                                                  "shape, whatever their format, pose, size and tessellation.",
                                              sections));
}

int list_duplicates(const DuplicatesOptions& options) {
  const auto limit = limit_threads(options.threads);
  search::Database database(options.database);
  search::Duplicates found;
  {
    std::unique_ptr<Progress> progress;
    found =
        search::find_duplicates(database, options.settings,
                                {stop_on_interrupt(), [&](std::size_t done, std::size_t total, const std::string& t) {
                                   if (!progress) progress = std::make_unique<Progress>(total);
                                   progress->show(done, t);
                                 }});
  }
  for (const std::string& error : found.errors) complain(error);
  if (!found.complete) {
    complain("stopped");
    return 1;
  }
  print_groups(found, options.json);
  if (!options.page.empty()) write_page(options.page, found);
  return found.errors.empty() ? 0 : 1;
}

}  // namespace

void add_duplicates_command(CLI::App& app, int& status) {
  auto options = std::make_shared<DuplicatesOptions>();
  CLI::App* command = app.add_subcommand("duplicates", "Find files of one shape in a database");
  command->add_option("database", options->database, "Database, made by 'rectilin index'")->required();
  command->add_flag("-j,--json", options->json, "A JSON object a line for each group");
  command->add_option("--page", options->page, "Write the groups with pictures, as a web page");
  command
      ->add_option("--tolerance", options->settings.tolerance,
                   "Root mean square distance of the surfaces up to which they are one shape, in radii")
      ->check(positive_number())
      ->capture_default_str();
  command->add_option("--neighbours", options->settings.neighbours, "Neighbours of each shape that are looked at")
      ->check(count())
      ->capture_default_str();
  add_threads_option(*command, options->threads, "the groups are the same for any");
  command->footer(
      "Copies are found whatever their format, position, rotation, scale and, within the tolerance, tessellation; "
      "mirror\n"
      "images are told apart. Each pair comes with how far the surfaces are apart when one is laid on the other, and\n"
      "both values of R. Nothing is changed or removed.\n"
      "Example: rectilin index parts/ -o parts.db; rectilin duplicates parts.db --page duplicates.html");
  command->callback([options, &status] { status = list_duplicates(*options); });
}

}  // namespace rectilin::app
