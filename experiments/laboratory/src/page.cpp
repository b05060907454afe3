#include "page.h"

#include "page_tables.h"
#include "rectilin/laboratory/plots.h"
#include "rectilin/report/html.h"

namespace rectilin::laboratory {
namespace {

using report::html::escape;
using report::html::heading;
using report::html::link;
using report::html::paragraph;

std::string picture(const PageImage& figure, const std::filesystem::path& folder) {
  if (figure.name.empty()) return "";  // no mesh could be measured
  const std::string base = "plots/" + figure.name;
  const std::string files = "Data: " + link(base + ".csv", "CSV") + ", " + link(base + ".gp", "gnuplot") + ".";
  if (!std::filesystem::exists(folder / (base + ".svg")))
    return paragraph("(No picture.) " + escape(figure.caption) + " " + files);
  return report::html::picture(base + ".svg", figure.caption, files, figure.width);
}

std::string introduction(const Results& results) {
  const Plan& plan = results.plan;
  const std::size_t planned = plan.meshes.size() * plan.entries.size() * static_cast<std::size_t>(plan.runs);
  std::string text =
      paragraph(std::to_string(plan.entries.size()) + " optimizers, " + std::to_string(plan.meshes.size()) +
                " meshes, " + std::to_string(plan.runs) + " runs of at most " +
                whole_number(static_cast<double>(plan.budget)) + " evaluations each, seed " +
                std::to_string(plan.seed) + ". Run k of every optimizer sees the same random rotation of the mesh.");
  if (results.runs.size() < planned)
    text += paragraph("<b>Incomplete:</b> " + std::to_string(results.runs.size()) + " of " + std::to_string(planned) +
                      " runs are there.");
  if (!plan.proves())
    return text + paragraph("What is searched is the <b>" + escape(plan.objective) +
                            "</b>, of which nothing can be proved: it has no cuts. The <b>gap</b> is the best value "
                            "that any run of this comparison, or a longer search (" +
                            escape(plan.certificate) +
                            ") before it, has found, against that of the best rotation this run has found. It may be "
                            "too small: a better value may exist. Where tables say \"certified\" they show that best "
                            "known value, turned around in sign.");
  text += paragraph(
      "The <b>gap</b> is the certified upper bound of R(M) less R at the best rotation a run has found: it is never "
      "too small. No gap below the width of the mesh's certificate can be told from none; it is shown as that width, "
      "and targets below it are left out for that mesh. Before its first evaluation a run has the largest gap there "
      "can be.");
  return text;
}

std::string mesh_sections(const Results& results, const PageFigures& figures, const std::filesystem::path& folder) {
  std::string text;
  std::size_t shown = 0;
  for (const MeshResult& mesh : results.meshes) {
    if (!mesh.error.empty()) continue;
    const PageFigures::OfMesh& own = figures.meshes[shown++];
    text += "<h3>" + escape(mesh.title) + "</h3>\n" +
            report::html::side_by_side(picture(own.evaluations, folder) + picture(own.seconds, folder)) +
            report::html::details("Bands, one panel an optimizer",
                                  picture(own.evaluation_bands, folder) + picture(own.second_bands, folder));
  }
  return text;
}

std::string files_html() {
  const auto item = [](const char* file, const char* what) {
    return "<li>" + link(file, file) + " " + what + "</li>\n";
  };
  return "<ul>\n" + item("summary.json", "all numbers of this page") + item("runs.csv", "one row a run") +
         item("meshes.csv", "certified bounds and best rotations") +
         item("ert.csv", "success rates and expected running times, every target") +
         item("tests.csv", "every rank-sum test") + item("runs.jsonl", "runs with their traces, as they finished") +
         item("meshes.jsonl", "the certificates") +
         item("provenance.json", "versions, processor, parameters, seeds, command lines") + "<li>" +
         link("ioh/", "ioh/") + " for IOHanalyzer and IOHinspector</li>\n<li>" + link("plots/", "plots/") +
         " each picture's CSV and gnuplot files; edit and draw again: gnuplot NAME.gp</li>\n</ul>\n";
}

}  // namespace

std::string comparison_page(const Results& results, const Summary& summary, const PageFigures& figures,
                            const Json& provenance, const std::filesystem::path& folder) {
  std::string body = introduction(results);
  body += heading("Who wins") + standings_html(results, summary);
  body += report::html::side_by_side(picture(figures.runtimes, folder) + picture(figures.runtimes_seconds, folder) +
                                     picture(figures.profile, folder));
  body += heading("Targets") + targets_html(results, summary) +
          report::html::details("Expected running time by mesh", mesh_targets_html(results, summary));
  body += heading("Where it is hard") + picture(figures.heat, folder);
  body += heading("Is the difference more than chance?") + tests_html(results, summary);
  body += domains_html(results, summary) + genetic_html(results);
  body += heading("What an evaluation costs") + usage_html(results, summary);
  body += heading("Meshes") + meshes_html(results);
  body += heading("Convergence") + mesh_sections(results, figures, folder);
  body += heading("Failures") + failures_html(results);
  body += heading("Files") + files_html();
  body += heading("Provenance") +
          report::html::details("Versions, processor, parameters, seeds, command lines",
                                "<pre>" + report::html::escape_lines(to_text(provenance, 2)) + "</pre>\n");
  return report::html::page("Comparison of optimizers", body);
}

}  // namespace rectilin::laboratory
