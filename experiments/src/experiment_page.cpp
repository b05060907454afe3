// The page that shows experiments, from what their folder holds.
#include <fstream>

#include "html.h"
#include "rectilin/experiments/csv.h"
#include "rectilin/experiments/experiment.h"

namespace rectilin {
namespace {

namespace fs = std::filesystem;

using html::escape;
using html::link;
using html::paragraph;

std::string picture(const Json& about, const fs::path& folder) {
  const std::string name = about.at("name"), caption = about.at("caption");
  std::string files = "Data: " + link(name + ".csv", "CSV");
  if (fs::exists(folder / (name + ".gp"))) files += ", " + link(name + ".gp", "gnuplot");
  files += ".";
  if (!fs::exists(folder / (name + ".svg")))
    return paragraph("(No picture.) " + escape(caption) + " " + files);
  return html::picture(name + ".svg", caption, files, about.at("width"));
}

std::string section(const Json& experiment, const fs::path& folder) {
  const std::string name = experiment.at("experiment"), title = experiment.at("title");
  std::string pictures;
  for (const Json& about : experiment.at("pictures")) pictures += picture(about, folder);
  std::string text = "<h2 id=\"" + escape(name) + "\">" + escape(name) + ": " + escape(title) +
                     "</h2>\n" + paragraph(escape(experiment.at("says").get<std::string>())) +
                     html::side_by_side(pictures);
  for (const Json& error : experiment.at("errors"))
    text += paragraph(escape(error.get<std::string>()));
  return text +
         html::details("Command, machine, versions",
                       "<pre>" + escape(experiment.at("provenance").dump(2)) + "</pre>\n" +
                           paragraph("All numbers: " + link(name + ".json", name + ".json")));
}

}  // namespace

void write_experiment_page(const fs::path& folder) {
  std::string contents, sections;
  for (const Experiment& experiment : experiments()) {
    std::ifstream in(folder / (experiment.name + ".json"));
    if (!in) continue;
    const Json stored = Json::parse(in);
    contents += "<li>" + link("#" + experiment.name, experiment.name) + ": " +
                escape(experiment.title) + "</li>\n";
    sections += section(stored, folder);
  }
  write_text(folder / "index.html", html::page("Rectilinearity: the experiments",
                                               "<ul>\n" + contents + "</ul>\n" + sections));
}

}  // namespace rectilin
