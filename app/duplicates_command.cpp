// rectilin duplicates: finds files of a database that hold the same shape.
#include <tbb/parallel_for.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.h"
#include "options.h"
#include "rectilin/base/printable.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/approximate.h"
#include "rectilin/search/duplicates.h"
#include "rectilin/search/page.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct DuplicatesOptions {
  std::string database, page, out;
  search::DuplicateOptions settings;
  bool json = false, approximate = false;
  int threads = 0;
};

/// The certified interval of a member's R, see Model::rectilinearity().
std::array<double, 2> interval_of(const search::Member& member) {
  return {member.rectilinearity, std::min(1.0, member.rectilinearity + 1e-6)};
}

std::string interval_text(const search::Member& member) {
  const auto [lower, upper] = interval_of(member);
  return fixed(lower, 6) + ".." + fixed(upper, 6);
}

/// Row by row, 3 x 4: the turn with its size, and the shift.
Json placement_json(const search::Placement& placement) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i)
    rows.push_back({placement.linear(i, 0), placement.linear(i, 1), placement.linear(i, 2), placement.shift(i)});
  return rows;
}

Json evidence_json(const search::DuplicateEvidence& e, const search::Duplicates& found) {
  const auto interval = [&](std::size_t member) {
    const auto [lower, upper] = interval_of(found.members[member]);
    return Json::array({lower, upper});
  };
  Json placed = e.same_bytes ? Json() : placement_json(e.placement);
  return {{"first", found.members[e.first].name},
          {"second", found.members[e.second].name},
          {"same_bytes", e.same_bytes},
          {"mirrored", e.mirrored},
          {"descriptor_distance", e.descriptor_distance},
          {"surface_distance", e.surface_distance},
          {"shared_vertices", e.shared_vertices},
          {"placement", std::move(placed)},
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
      std::cout << "surfaces " << general(e.surface_distance, 2) << " radii apart, "
                << fixed(100 * e.shared_vertices, 0) << " % of vertices the same"
                << (e.mirrored ? " when mirrored" : "") << ", scale " << general(e.scale, 5) << ", R "
                << interval_text(found.members[e.first]) << " and " << interval_text(found.members[e.second]) << '\n';
    }
  }
  if (!json)
    std::cout << found.groups.size() << " groups in " << found.members.size() << " shapes, " << found.pairs_looked_at
              << " pairs looked at\n";
}

/// A picture for each pair of a group: one surface laid on the other. Empty for files of the same bytes and for those
/// that cannot be read any more.
using Overlays = std::vector<std::vector<std::string>>;
Overlays overlays_of(const search::Duplicates& found) {
  std::vector<std::pair<const search::DuplicateEvidence*, std::string*>> pairs;
  Overlays overlays;
  for (const search::DuplicateGroup& group : found.groups) overlays.emplace_back(group.evidence.size());
  for (std::size_t g = 0; g < overlays.size(); ++g)
    for (std::size_t k = 0; k < overlays[g].size(); ++k)
      if (!found.groups[g].evidence[k].same_bytes) pairs.emplace_back(&found.groups[g].evidence[k], &overlays[g][k]);
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    const search::DuplicateEvidence& e = *pairs[i].first;
    try {
      *pairs[i].second = search::overlay_picture(load_mesh(found.members[e.first].source).mesh,
                                                 load_mesh(found.members[e.second].source).mesh, e.placement);
    } catch (const std::exception&) {  // it was moved since: the group is listed without the picture
    }
  });
  return overlays;
}

void write_page(const std::string& file, const search::Duplicates& found, const Overlays& overlays) {
  std::vector<search::PageSection> sections;
  for (const search::DuplicateGroup& group : found.groups) {
    search::PageSection section{"Group " + std::to_string(sections.size() + 1), {}};
    for (std::size_t k = 0; k < group.members.size(); ++k) {
      const search::Member& m = found.members[group.members[k]];
      section.pictures.push_back(
          {m.name, m.source, group.mirrored[k] ? "mirrored" : "R " + fixed(m.rectilinearity, 6)});
    }
    for (std::size_t k = 0; k < group.evidence.size(); ++k) {
      const search::DuplicateEvidence& e = group.evidence[k];
      const std::string& png = overlays[sections.size()][k];
      if (png.empty()) continue;
      section.pictures.push_back({found.members[e.first].name + ", " + found.members[e.second].name, "",
                                  general(e.surface_distance, 2) + " radii apart", png});
    }
    sections.push_back(std::move(section));
  }
  write_whole_file(
      file, search::picture_page(
                "Duplicates",
                std::to_string(found.groups.size()) +
                    " groups of files that are one shape, whatever their format, pose, size and tessellation. The "
                    "members come first, then pairs of them, one laid on the other: grey where they coincide, blue "
                    "what only the first has, orange what only the second has.",
                sections));
}

void write_overlays(const std::filesystem::path& folder, const Overlays& overlays) {
  std::filesystem::create_directories(folder);
  for (std::size_t g = 0; g < overlays.size(); ++g)
    for (std::size_t k = 0; k < overlays[g].size(); ++k)
      if (!overlays[g][k].empty())
        write_whole_file(folder / ("group" + std::to_string(g + 1) + "-" + std::to_string(k + 1) + ".png"),
                         overlays[g][k]);
}

int list_duplicates(const DuplicatesOptions& options) {
  const auto limit = limit_threads(options.threads);
  search::Database database(options.database);
  search::DuplicateOptions settings = options.settings;
  if (options.approximate) settings.graph = search::graph_file(options.database);
  search::Duplicates found;
  {
    std::unique_ptr<Progress> progress;
    std::size_t of = 0;  // neighbours are looked for first, then pairs are compared
    found = search::find_duplicates(
        database, settings, {stop_on_interrupt(), [&](std::size_t done, std::size_t total, const std::string& t) {
                               if (total != of) progress.reset();
                               if (!progress) progress = std::make_unique<Progress>(of = total);
                               progress->show(done, t);
                             }});
  }
  if (!found.note.empty()) complain(found.note);
  for (const std::string& error : found.errors) complain(error);
  if (!found.complete) {
    complain("stopped");
    return 1;
  }
  print_groups(found, options.json);
  if (!options.page.empty() || !options.out.empty()) {
    const Overlays overlays = overlays_of(found);
    if (!options.page.empty()) write_page(options.page, found, overlays);
    if (!options.out.empty()) write_overlays(options.out, overlays);
  }
  return found.errors.empty() ? 0 : 1;
}

}  // namespace

void add_duplicates_command(CLI::App& app, int& status) {
  auto options = std::make_shared<DuplicatesOptions>();
  CLI::App* command = app.add_subcommand("duplicates", "Find files of one shape in a database");
  command->add_option("database", options->database, "Database, made by 'rectilin index'")->required();
  command->add_flag("-j,--json", options->json, "A JSON object a line for each group");
  command->add_option("--page", options->page, "Write the groups with pictures, as a web page");
  command->add_option(
      "-O,--out", options->out,
      "Folder for pictures of one surface laid on the other, groupG-P.png for the P-th pair of group G");
  command
      ->add_option("--tolerance", options->settings.tolerance,
                   "Root mean square distance of the surfaces up to which they are one shape, in radii")
      ->check(positive_number())
      ->capture_default_str();
  command
      ->add_option(
          "--shared", options->settings.shared,
          "Share of the coarser mesh's vertices that, if they are the other's, too, make it a simplified copy, though "
          "the surfaces are further apart; above 1: never")
      ->check(positive_number())
      ->capture_default_str();
  command->add_option("--neighbours", options->settings.neighbours, "Neighbours of each shape that are looked at")
      ->check(count())
      ->capture_default_str();
  command->add_flag(
      "--approximate", options->approximate,
      "Find neighbours by a graph in DATABASE-graph, built when needed: beyond 20,000 shapes or so, where "
      "looking at all for each takes long; a pair may be missed");
  add_threads_option(*command, options->threads, "the groups are the same for any");
  command->footer(
      "Copies are found whatever their format, position, rotation, scale and, within the tolerance, tessellation; "
      "mirror\n"
      "images are told apart. Each pair comes with how far the surfaces are apart when one is laid on the other,\n"
      "how many of the coarser mesh's vertices are the other's, too, and intervals of both R. Nothing is changed "
      "or removed.\n"
      "Example: rectilin index parts/ -o parts.db; rectilin duplicates parts.db --page duplicates.html");
  command->callback([options, &status] { status = list_duplicates(*options); });
}

}  // namespace rectilin::app
