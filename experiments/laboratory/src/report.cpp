#include "rectilin/laboratory/report.h"

#include <cmath>
#include <fstream>

#include "page.h"
#include "rectilin/base/folder_lock.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/ioh.h"
#include "rectilin/laboratory/plots.h"
#include "rectilin/laboratory/summary.h"
#include "rectilin/report/csv.h"

namespace rectilin::laboratory {
namespace {

namespace fs = std::filesystem;

std::vector<report::Csv::Cell> rotation_cells(const Rotation& rotation) {
  std::vector<report::Csv::Cell> cells;
  for (int k = 0; k < 9; ++k) cells.push_back(rotation.matrix()(k / 3, k % 3));
  return cells;
}

std::vector<std::string> with_rotation(std::vector<std::string> columns) {
  for (const char* name : {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"}) columns.push_back(name);
  return columns;
}

report::Csv runs_table(const Results& results) {
  report::Csv table(
      with_rotation({"mesh", "optimizer", "domain", "run", "seed", "outcome", "error", "rectilinearity", "gap",
                     "evaluations", "values", "cuts", "smooths", "turns", "seconds", "cpu_seconds", "digest"}));
  for (const RunResult& run : results.runs) {
    const auto text = [&](const char* key) { return run.record.at(key).get<std::string>(); };
    const auto number = [&](const char* key) { return run.record.at(key).get<double>(); };
    std::vector<report::Csv::Cell> row = {results.meshes[run.mesh].name,
                                          results.plan.entries[run.entry].label,
                                          text("domain"),
                                          run.run + 1,
                                          std::to_string(run.record.at("seed").get<std::uint64_t>()),
                                          text("outcome"),
                                          text("error"),
                                          run.merit,
                                          run.trace.final_gap(),
                                          run.evaluations,
                                          number("values"),
                                          number("cuts"),
                                          number("smooths"),
                                          number("turns"),
                                          run.seconds,
                                          run.cpu_seconds,
                                          text("digest")};
    const std::vector<report::Csv::Cell> rotation = rotation_cells(run.rotation);
    row.insert(row.end(), rotation.begin(), rotation.end());
    table.row(row);
  }
  return table;
}

report::Csv meshes_table(const Results& results) {
  report::Csv table(with_rotation({"mesh", "error", "left_out", "faces", "directions", "area", "lower", "upper",
                           "certificate_evaluations", "certificate_seconds"}));
  for (const MeshResult& mesh : results.meshes) {
    const bool known = mesh.error.empty();
    std::vector<report::Csv::Cell> row = {mesh.name, mesh.error, mesh.left_out};
    for (const double x : {static_cast<double>(mesh.faces), static_cast<double>(mesh.directions), mesh.area, mesh.lower,
                           mesh.upper, mesh.evaluations, mesh.seconds})
      row.push_back(known ? x : NAN);
    for (const report::Csv::Cell& cell : rotation_cells(mesh.rotation))
      row.push_back(known ? cell : report::Csv::Cell(""));
    table.row(row);
  }
  return table;
}

report::Csv targets_table(const Results& results, const Summary& summary) {
  report::Csv table({"optimizer", "mesh", "target", "runs", "success_rate", "expected_running_time"});
  for (std::size_t e = 0; e < summary.cells.size(); ++e)
    for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh)
      for (std::size_t t = 0; t < targets().size(); ++t) {
        const RunningTime& time = summary.cells[e][mesh].to_target[t];
        if (time.runs > 0)
          table.row({results.plan.entries[e].label, results.meshes[mesh].name, target_name(targets()[t]), time.runs,
                     time.success_rate(), time.expected()});
      }
  return table;
}

report::Csv tests_table(const Results& results, const Summary& summary) {
  report::Csv table({"mesh", "first", "second", "u", "superiority_of_first", "p", "p_holm"});
  for (const PairTest& t : summary.tests)
    table.row({results.meshes[t.mesh].name, results.plan.entries[t.first].label, results.plan.entries[t.second].label,
               t.test.u, t.test.superiority, t.test.p, t.corrected});
  return table;
}

/// Writes the files of plots as they are added, and draws all of them at the end.
class Gallery {
 public:
  explicit Gallery(fs::path folder) : folder_(std::move(folder)) { fs::create_directories(folder_); }

  PageImage add(const report::NamedPlot& plot) {
    plot.plot.write(folder_, plot.name);
    names_.push_back(plot.name);
    return {plot.name, plot.caption, plot.plot.width()};
  }

  report::PictureTroubles draw_all() const { return report::draw_all(folder_, names_); }

 private:
  fs::path folder_;
  std::vector<std::string> names_;
};

PagePlots add_plots(const Results& results, const Summary& summary, Gallery& gallery) {
  PagePlots figures;
  if (std::ranges::none_of(results.meshes, [](const MeshResult& mesh) { return mesh.error.empty(); })) return figures;
  figures.runtimes = gallery.add(runtime_plot(results, Cost::kEvaluations));
  figures.runtimes_seconds = gallery.add(runtime_plot(results, Cost::kSeconds));
  figures.profile = gallery.add(profile_plot(results, summary));
  figures.heat = gallery.add(heat_plot(results, summary));
  for (std::size_t mesh = 0; mesh < results.meshes.size(); ++mesh) {
    if (!results.meshes[mesh].error.empty()) continue;
    figures.meshes.push_back({gallery.add(convergence_plot(results, mesh, Cost::kEvaluations)),
                              gallery.add(convergence_plot(results, mesh, Cost::kSeconds)),
                              gallery.add(band_plot(results, mesh, Cost::kEvaluations)),
                              gallery.add(band_plot(results, mesh, Cost::kSeconds))});
  }
  return figures;
}

}  // namespace

report::PictureTroubles write_report(const fs::path& folder) { return write_report(folder, FolderLock(folder)); }

report::PictureTroubles write_report(const fs::path& folder, const FolderLock&) {
  const Results results = load_results(folder);
  const Summary summary = summarise(results);
  runs_table(results).write(folder / "runs.csv");
  meshes_table(results).write(folder / "meshes.csv");
  targets_table(results, summary).write(folder / "ert.csv");
  tests_table(results, summary).write(folder / "tests.csv");
  write_whole_file(folder / "summary.json", to_text(to_json(summary, results), 1) + '\n');
  export_ioh(results, folder / "ioh");

  Gallery gallery(folder / "plots");
  const PagePlots figures = add_plots(results, summary, gallery);
  report::PictureTroubles troubles = gallery.draw_all();
  write_whole_file(folder / "index.html",
                   comparison_page(results, summary, figures, read_json_or_null(folder / "provenance.json"), folder));
  return troubles;
}

}  // namespace rectilin::laboratory
