// The page that shows experiments, made from the files in their folder.
#include <fstream>

#include "rectilin/base/whole_file.h"
#include "rectilin/paper/experiment.h"
#include "rectilin/report/html.h"

namespace rectilin::paper {
namespace {

namespace fs = std::filesystem;

using report::html::escape;
using report::html::link;
using report::html::paragraph;

std::string picture(const Json& about, const fs::path& folder) {
  const std::string name = about.at("name"), caption = about.at("caption");
  std::string files = "Data: " + link(name + ".csv", "CSV");
  if (fs::exists(folder / (name + ".gp"))) files += ", " + link(name + ".gp", "gnuplot");
  files += ".";
  if (!fs::exists(folder / (name + ".svg"))) return paragraph("(No picture.) " + escape(caption) + " " + files);
  return report::html::picture(name + ".svg", caption, files, about.at("width"));
}

std::string table_of(const Json& experiment) {
  std::string text;
  const Json table = experiment.value("table", Json::array());
  if (table.empty()) return text;
  const auto cells = [](const Json& row) {
    std::vector<std::string> list;
    for (const Json& cell : row) list.push_back(escape(cell.get<std::string>()));
    return list;
  };
  report::html::Table html(cells(table.front()));
  for (std::size_t i = 1; i < table.size(); ++i) html.row(cells(table[i]));
  return html.text() + paragraph(escape(experiment.value("table_says", "")));
}

/// Everything that is needed to repeat an experiment.
Json record(const Json& experiment) {
  Json all;
  for (const char* key : {"settings", "meshes", "seed", "gap"}) all[key] = experiment.at(key);
  all.update(experiment.at("provenance"));
  return all;
}

std::string section(const Json& experiment, const fs::path& folder) {
  const std::string name = experiment.at("experiment"), title = experiment.at("title");
  std::string pictures;
  for (const Json& about : experiment.at("pictures")) pictures += picture(about, folder);
  std::string text = "<h2 id=\"" + escape(name) + "\">" + escape(name) + ": " + escape(title) + "</h2>\n" +
                     paragraph(escape(experiment.at("says").get<std::string>())) + report::html::side_by_side(pictures);
  text += table_of(experiment);
  for (const Json& error : experiment.at("errors")) text += paragraph(escape(error.get<std::string>()));
  for (const Json& loss : experiment.value("left_out", Json::array()))
    text += paragraph("Not all of " + escape(loss.get<std::string>()));
  return text + report::html::details("Settings, command, machine, versions",
                                      "<pre>" + escape(to_text(record(experiment), 2)) + "</pre>\n" +
                                          paragraph("All numbers: " + link(name + ".json", name + ".json")));
}

std::string introduction() {
  return paragraph(
      "What the figures of the paper (Lian, Rosin and Sun, IJCV 2010) show, measured again. Below "
      "each title stands what came out, beside what the paper reports. R of a mesh is proved: no "
      "rotation has one that is larger by more than the gap on record. A picture opens on its own "
      "when clicked.");
}

/// What an experiment left in the folder; nothing if it is not there.
Json stored(const std::string& name, const fs::path& folder) {
  Json all = read_json_or_null(folder / (name + ".json"));
  return all.is_object() && all.value("experiment", "") == name ? all : Json();
}

}  // namespace

void write_experiment_page(const fs::path& folder) {
  std::string contents, sections;
  for (const Experiment& experiment : experiments()) {
    const Json found = stored(experiment.name, folder);
    if (found.is_null()) continue;
    contents += "<li>" + link("#" + experiment.name, experiment.name) + ": " + escape(experiment.help) + "</li>\n";
    sections += section(found, folder);
  }
  write_whole_file(folder / "index.html",
                   report::html::page("Rectilinearity: the experiments",
                                      introduction() + "<ul>\n" + contents + "</ul>\n" + sections));
}

}  // namespace rectilin::paper
