// rectilin measure: from files and shapes to R(M).
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>

#include "commands.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/source.h"
#include "rectilin/optim/registry.h"
#include "rectilin/optim/run_record.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct MeasureOptions {
  std::vector<std::string> sources;
  std::string optimizer = "ga";
  std::string domain = "covering";
  std::uint64_t seed = 1;
  std::uint64_t evaluations = Budget().evaluations;
  int threads = 0;
  bool json = false;
};

/// One row of the result: a measured mesh, or why there is none.
struct Row {
  std::string name;
  std::string error;
  MeshReport report;
  std::size_t faces = 0, directions = 0;
  double area = 0;
  RunRecord run;
};

Row measure_source(const std::string& source, const Optimizer& optimizer, const RunSettings& settings) {
  Row row;
  row.name = source;
  try {
    const LoadedMesh loaded = load_mesh(source);
    const ProjectedArea objective(area_vectors(loaded.mesh), source);
    row.report = loaded.report;
    row.faces = loaded.mesh.triangles.size();
    row.directions = objective.vectors().size();
    row.area = objective.vectors().area();
    row.run = run_optimizer(optimizer, objective, settings);
    row.error = row.run.error;
  } catch (const std::exception& e) {
    row.error = e.what();
  }
  return row;
}

Json to_json(const MeshReport& r) {
  return {{"vertices", r.vertices},
          {"polygons", r.polygons},
          {"triangulated", r.triangulated},
          {"nonfinite_vertices", r.nonfinite_vertices},
          {"dropped_nonfinite", r.dropped_nonfinite},
          {"dropped_short", r.dropped_short},
          {"degenerate", r.degenerate},
          {"duplicate_vertices", r.duplicate_vertices},
          {"unreferenced_vertices", r.unreferenced_vertices}};
}

Json to_json(const Row& row) {
  if (!row.error.empty()) return {{"name", row.name}, {"error", row.error}};
  const RunRecord& run = row.run;
  const bool certified = run.lower.has_value();
  Json line = {{"name", row.name},
               {"faces", row.faces},
               {"directions", row.directions},
               {"area", row.area},
               {"rectilinearity", run.merit},
               {"lower", certified ? Json(run.merit) : Json(nullptr)},
               {"upper", certified ? Json(rectilinearity(*run.lower)) : Json(nullptr)},
               {"rotation", rectilin::to_json(run.incumbent.rotation)}};
  const Json details = rectilin::to_json(run);
  for (const char* key : {"optimizer", "parameters", "domain", "seed", "outcome", "evaluations", "values",
                          "cuts", "smooths", "turns", "seconds", "cpu_seconds", "threads", "digest"})
    line[key] = details[key];
  line["report"] = to_json(row.report);
  return line;
}

/// Prints rows in the order of the sources, as they come.
class Printer {
 public:
  Printer(const MeasureOptions& options, const std::vector<std::string>& sources)
      : json_(options.json), progress_(sources.size()), table_(columns(sources)) {
    if (!json_) std::cout << table_.header() << '\n' << std::flush;
    if (!sources.empty()) progress_.show(0, sources.front());
  }

  void print(const Row& row) {
    progress_.clear();
    ++done_;
    if (!row.error.empty()) {
      ++failed_;
      // Errors of files begin with the file's name; the others do not.
      complain(row.error.starts_with(row.name) ? row.error : row.name + ": " + row.error);
    }
    if (json_) std::cout << to_json(row).dump() << '\n';
    else if (row.error.empty()) std::cout << table_.row(cells(row)) << '\n';
    std::cout << std::flush;
    progress_.show(done_, row.name);
  }

  std::size_t failed() const { return failed_; }

 private:
  static std::vector<Table::Column> columns(const std::vector<std::string>& sources) {
    std::size_t widest = 0;
    for (const auto& s : sources) widest = std::max(widest, s.size());
    return {{"name", widest}, {"faces", 8}, {"directions", 8}, {"area", 11}, {"R", 12},
            {"alpha", 8}, {"beta", 8}, {"gamma", 8}, {"optimizer", 9}, {"evaluations", 8}, {"seconds", 8}};
  }

  static std::vector<std::string> cells(const Row& row) {
    const Eigen::Vector3d degrees =
        euler_from_rotation(row.run.incumbent.rotation) * (180 / std::numbers::pi);
    return {row.name, std::to_string(row.faces), std::to_string(row.directions), general(row.area, 6),
            fixed(row.run.merit, 10), fixed(degrees[0], 3), fixed(degrees[1], 3), fixed(degrees[2], 3),
            row.run.optimizer, std::to_string(row.run.costs.evaluations()), fixed(row.run.seconds, 3)};
  }

  bool json_;
  Progress progress_;
  Table table_;
  std::size_t done_ = 0, failed_ = 0;
};

std::vector<std::string> lines_of(std::istream& in) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

int measure(const MeasureOptions& options) {
  const auto optimizer = builtin_optimizers().make(options.optimizer);
  RunSettings settings;
  settings.budget.evaluations = options.evaluations;
  settings.seed = options.seed;
  settings.chart = &chart_by_name(options.domain);
  settings.stop = stop_on_interrupt();

  std::vector<std::string> given;
  for (const std::string& source : options.sources) {
    if (source != "-") given.push_back(source);
    else for (const std::string& line : lines_of(std::cin)) given.push_back(line);
  }
  const std::vector<std::string> sources = expand_folders(given);
  if (sources.empty()) throw MeshError("the list of files is empty");

  std::optional<tbb::global_control> limit;
  if (options.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  const std::size_t at_once = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);

  // Several files at once, rows in order. Isolated, because a thread that waits for the loops inside one
  // file must not pick up another file and charge its time to the first.
  Printer printer(options, sources);
  std::size_t next = 0;
  tbb::parallel_pipeline(
      at_once,
      tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order,
                                          [&](tbb::flow_control& flow) {
                                            if (next == sources.size() || settings.stop.stop_requested()) flow.stop();
                                            return next++;
                                          }) &
          tbb::make_filter<std::size_t, std::shared_ptr<Row>>(
              tbb::filter_mode::parallel,
              [&](std::size_t i) {
                auto row = std::make_shared<Row>();
                tbb::this_task_arena::isolate([&] { *row = measure_source(sources[i], *optimizer, settings); });
                return row;
              }) &
          tbb::make_filter<std::shared_ptr<Row>, void>(
              tbb::filter_mode::serial_in_order, [&](const std::shared_ptr<Row>& row) { printer.print(*row); }));
  return printer.failed() > 0 || settings.stop.stop_requested() ? 1 : 0;
}

}  // namespace

void add_measure_command(CLI::App& app, int& status) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command = app.add_subcommand("measure", "Measure R(M) and the pose of meshes");
  command->add_option("source", options->sources,
                      "Mesh files (.off .obj .ply .stl), folders of them, built-in shapes (shape:NAME?key=value, "
                      "see 'rectilin shapes'), or - for a list on standard input")
      ->required();
  command->add_option("-o,--optimizer", options->optimizer,
                      "Optimizer, with parameters: ga?population=100 (see 'rectilin optimizers')")
      ->capture_default_str();
  command->add_option("-d,--domain", options->domain,
                      "Box that optimizers on a chart search: paper ([0,90]^3 degrees, three quarters of all "
                      "orientations), covering ([0,180]x[0,90]^2, all), zone (Rodrigues cube, all)")
      ->check(CLI::IsMember({"paper", "covering", "zone"}))
      ->capture_default_str();
  command->add_option("-s,--seed", options->seed, "Seed of the random numbers")->capture_default_str();
  command->add_option("-b,--budget", options->evaluations, "Evaluations at most, per mesh (default: no limit)");
  command->add_option("-t,--threads", options->threads, "Threads (default: all); the answer is the same for any")
      ->check(CLI::PositiveNumber);
  command->add_flag("-j,--json", options->json, "One JSON object a line instead of the table");
  command->footer(
      "The angles printed are the paper's alpha, beta, gamma (eqs. 35-37) in degrees, of the rotation that takes\n"
      "the mesh to its best pose. A file that cannot be measured costs its own row and the exit status (1).\n"
      "Examples: rectilin measure chair.off\n"
      "          rectilin measure --json meshes/ > results.jsonl\n"
      "          rectilin measure --optimizer grid --domain zone 'shape:cylinder?sides=64'");
  command->callback([options, &status] { status = measure(*options); });
}

}  // namespace rectilin::app
