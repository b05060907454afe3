// rectilin measure: from files and shapes to R(M).
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>

#include "commands.h"
#include "rectilin/measure/projected_area.h"
#include "rectilin/measure/source.h"
#include "rectilin/measure/verify.h"
#include "rectilin/optim/certify.h"
#include "rectilin/optim/registry.h"
#include "rectilin/optim/run_record.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

struct MeasureOptions {
  std::vector<std::string> sources;
  std::string optimizer = Certify::kName;
  std::optional<double> gap;
  bool optima = false;
  std::string proof;
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
  double value_error = 0;  ///< rounding of the objective's values
  std::optional<CertifyResult> certified;
  Json parallel_faces;
};

/// Certify, keeping what a run record has no place for.
class CertifyInDetail final : public Optimizer {
 public:
  CertifyInDetail(const Certify& certify, bool prove) : certify_(certify), prove_(prove) {}

  std::string name() const override { return certify_.name(); }
  Json parameters() const override { return certify_.parameters(); }
  Capabilities capabilities() const override { return certify_.capabilities(); }
  void run(Evaluator& evaluator, const Chart&, Random&) const override {
    result = certify(evaluator, certify_.options(), prove_ ? &certificate : nullptr);
  }

  mutable std::optional<CertifyResult> result;
  mutable Certificate certificate;

 private:
  const Certify& certify_;
  bool prove_;
};

/// For each axis the triangles parallel to it: how many, and the first few.
Json parallel_faces(const Mesh& mesh, const Rotation& rotation) {
  constexpr std::size_t kShown = 10;
  Json lists = Json::array();
  for (int k = 0; k < 3; ++k) {
    std::size_t count = 0;
    Json faces = Json::array();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const Vector3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]], b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
      const Vector3 normal = a.normalized().cross(b.normalized()).normalized();
      if (normal.isZero() || !(std::abs(rotation.axis(k).dot(normal)) <= 1e-9)) continue;
      if (++count <= kShown) faces.push_back(i);
    }
    lists.push_back({{"count", count}, {"faces", faces}});
  }
  return lists;
}

void write_proof(const std::string& file, const Certificate& certificate, const Mesh& mesh) {
  std::ofstream out(file);
  out << rectilin::to_json(certificate, mesh_digest(mesh)).dump() << '\n';
  if (!out.flush()) throw MeshError(file + ": cannot be written");
}

Row measure_source(const std::string& source, const Optimizer& optimizer, const RunSettings& settings,
                   const std::string& proof) {
  Row row;
  row.name = source;
  try {
    const LoadedMesh loaded = load_mesh(source);
    const ProjectedArea objective(area_vectors(loaded.mesh), source);
    row.report = loaded.report;
    row.faces = loaded.mesh.triangles.size();
    row.directions = objective.vectors().size();
    row.area = objective.vectors().area();
    row.value_error = 3 * objective.cut_bounds().error;
    if (const auto* certify = dynamic_cast<const Certify*>(&optimizer)) {
      const CertifyInDetail detailed(*certify, !proof.empty());
      row.run = run_optimizer(detailed, objective, settings);
      row.certified = detailed.result;
      if (row.certified) row.parallel_faces = parallel_faces(loaded.mesh, row.run.incumbent.rotation);
      if (!proof.empty() && row.run.error.empty()) write_proof(proof, detailed.certificate, loaded.mesh);
    } else {
      row.run = run_optimizer(optimizer, objective, settings);
    }
    row.error = row.run.error;
    if (row.error.empty() && row.run.costs.evaluations() == 0) row.error = "the budget ends before the first rotation";
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

const char* to_string(Optimum::Kind kind) {
  switch (kind) {
    case Optimum::Kind::kPoint: return "point";
    case Optimum::Kind::kContinuum: return "continuum";
    case Optimum::Kind::kPossible: return "possible";
  }
  return "";
}

Json to_json(const std::vector<Optimum>& optima) {
  Json list = Json::array();
  for (const Optimum& optimum : optima)
    list.push_back({{"kind", to_string(optimum.kind)},
                    {"rectilinearity", rectilinearity(optimum.value)},
                    {"rotation", rectilin::to_json(optimum.rotation)}});
  return list;
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
               {"lower", certified ? Json(rectilinearity(run.incumbent.value + row.value_error)) : Json(nullptr)},
               {"upper", certified ? Json(rectilinearity(*run.lower)) : Json(nullptr)},
               {"rotation", rectilin::to_json(run.incumbent.rotation)}};
  const Json details = rectilin::to_json(run);
  for (const char* key : {"optimizer", "parameters", "domain", "seed", "outcome", "evaluations", "values",
                          "cuts", "smooths", "turns", "seconds", "cpu_seconds", "threads", "digest"})
    line[key] = details[key];
  if (row.certified) {
    line["cells"] = row.certified->cells;
    line["parallel_faces"] = row.parallel_faces;
    if (!row.certified->optima.empty()) line["optima"] = to_json(row.certified->optima);
  }
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
    return {{"name", widest}, {"faces", 8}, {"directions", 8}, {"area", 11}, {"R", 12}, {"at most", 12},
            {"alpha", 8}, {"beta", 8}, {"gamma", 8}, {"optimizer", 9}, {"evaluations", 8}, {"seconds", 8}};
  }

  static std::vector<std::string> cells(const Row& row) {
    const Eigen::Vector3d degrees =
        euler_from_rotation(row.run.incumbent.rotation) * (180 / std::numbers::pi);
    return {row.name, std::to_string(row.faces), std::to_string(row.directions), general(row.area, 6),
            fixed(row.run.merit, 10), row.run.lower ? fixed(rectilinearity(*row.run.lower), 10) : "-", fixed(degrees[0], 3), fixed(degrees[1], 3), fixed(degrees[2], 3),
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

/// The optimizer asked for, with the options that only Certify has.
std::unique_ptr<Optimizer> make_optimizer(const MeasureOptions& options) {
  if (!options.gap && !options.optima && options.proof.empty()) return builtin_optimizers().make(options.optimizer);
  Spec spec = Spec::parse(options.optimizer);
  if (spec.name != Certify::kName)
    throw ParameterError("--gap, --optima and --proof need the optimizer " + std::string(Certify::kName));
  if (options.gap) spec.settings["gap"] = *options.gap;
  if (options.optima) spec.settings["optima"] = true;
  return builtin_optimizers().make(spec.name, spec.settings);
}

int measure(const MeasureOptions& options) {
  const auto optimizer = make_optimizer(options);
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
  if (!options.proof.empty() && sources.size() > 1) throw ParameterError("--proof is for one mesh at a time");

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
                tbb::this_task_arena::isolate([&] { *row = measure_source(sources[i], *optimizer, settings, options.proof); });
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
  command->add_option("-g,--gap", options->gap, "Width to which certify encloses R (default: 1e-6)")
      ->check(CLI::NonNegativeNumber);
  command->add_option("-p,--proof", options->proof,
                      "File for a proof of the bounds, one mesh; 'rectilin verify' checks it");
  command->add_flag("--optima", options->optima, "Find all poses within the gap (shown with --json)");
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
      "R is that of the pose found; no pose has more than 'at most', where an optimizer proves it.\n"
      "Examples: rectilin measure chair.off\n"
      "          rectilin measure --json meshes/ > results.jsonl\n"
      "          rectilin measure --optimizer grid --domain zone 'shape:cylinder?sides=64'");
  command->callback([options, &status] { status = measure(*options); });
}

}  // namespace rectilin::app
