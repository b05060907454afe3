#include "rectilin/laboratory/work.h"

#include <cmath>
#include <limits>

#include "rectilin/measure/verify.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "turned_objective.h"

namespace rectilin::laboratory {
namespace {

/// How many budgets of a run the search for the best known value gets.
constexpr std::uint64_t kReferenceBudgets = 10;

/// The fields of a line that differ between equal runs.
constexpr const char* kTimes[] = {"seconds", "cpu_seconds", "threads"};

Json trace_json(const RunRecord& record, const Objective& objective) {
  Json evaluations = Json::array(), seconds = Json::array(), merit = Json::array();
  double best = std::numeric_limits<double>::infinity();
  for (const TracePoint& point : record.trace) {
    if (!(point.value < best)) continue;  // here the bound rose, not the incumbent
    best = point.value;
    evaluations.push_back(point.evaluations);
    seconds.push_back(std::round(point.seconds * 1e7) / 1e7);
    merit.push_back(objective.merit(point.value));
  }
  return {{"evaluations", evaluations}, {"seconds", seconds}, {"merit", merit}};
}

std::unique_ptr<const Objective> turned(const Problem& problem, const Rotation& rotation) {
  if (problem.other) return std::make_unique<TurnedObjective>(problem.other, rotation);
  return std::make_unique<ProjectedArea>(rotated(problem.mesh.vectors, rotation), problem.name);
}

}  // namespace

ComparedMesh load_compared_mesh(const std::string& source) { return compared_mesh(load_mesh(source)); }

ComparedMesh compared_mesh(const LoadedMesh& loaded) {
  const Mesh& mesh = loaded.mesh;
  return {area_vectors(mesh), mesh.triangles.size(), mesh_digest(mesh), summary(loaded.report)};
}

ComparisonWork::ComparisonWork(const Plan& plan, const Registry& registry)
    : plan_(plan),
      certifier_(plan.proves() ? measure_options(plan.certificate, registry) : MeasureOptions()),
      reference_(plan.proves() ? nullptr : registry.make(plan.certificate)) {
  for (const Entry& entry : plan.entries) optimizers_.push_back(registry.make(entry.spec));
}

/// For objectives without proof: the best value that a search finds on the mesh as it is, in the form of the line that
/// bounds would have.
std::optional<Json> ComparisonWork::search_reference(const Problem& problem, std::stop_token stop) const {
  RunSettings settings;
  settings.budget.evaluations = kReferenceBudgets * plan_.budget;
  settings.seed = plan_.seed;
  settings.stop = std::move(stop);
  const RunRecord record = run_optimizer(*reference_, *problem.other, settings);
  if (record.outcome == RunRecord::Outcome::kStopped) return std::nullopt;
  if (!record.error.empty()) throw std::runtime_error(problem.name + ": " + record.error);
  const AreaVectors& vectors = problem.mesh.vectors;
  Json line = {{"faces", problem.mesh.faces},  {"directions", vectors.size()}, {"area", vectors.area()},
               {"objective", plan_.objective}, {"merit", record.merit},        {"upper", nullptr}};
  line.update(to_json(record));
  return line;
}

std::optional<Json> ComparisonWork::bound(const Problem& problem, std::stop_token stop,
                                          const std::function<void(const Evaluator&)>& on_progress) const {
  Json line = {{"mesh", problem.name}};
  if (!problem.mesh.left_out.empty()) line["left_out"] = problem.mesh.left_out;
  line["mesh_digest"] = problem.mesh.digest;
  if (problem.other) {
    const std::optional<Json> found = search_reference(problem, std::move(stop));
    if (!found) return std::nullopt;
    line.update(*found);
    return line;
  }
  MeasureOptions options = certifier_;
  options.run.seed = plan_.seed;
  options.run.stop = std::move(stop);
  options.run.on_progress = on_progress;
  Rectilinearity result = measure(ProjectedArea(problem.mesh.vectors, problem.name), options);
  if (result.run.outcome == RunRecord::Outcome::kStopped) return std::nullopt;
  result.faces = problem.mesh.faces;
  line.update(to_json(result));
  return line;
}

Json ComparisonWork::unmeasured(const std::string& mesh, const std::string& error) {
  return {{"mesh", mesh}, {"error", error}};
}

Json ComparisonWork::run_line(const std::string& mesh, std::size_t entry, int run, const RunRecord& record) const {
  Json line = {{"mesh", mesh}, {"entry", plan_.entries[entry].label}, {"run", run}};
  line.update(to_json(record));
  line["instance"] = to_json(instance(plan_.seed, mesh, run).rotation);
  return line;
}

std::optional<Json> ComparisonWork::run(const Problem& problem, std::size_t entry, int run,
                                        std::stop_token stop) const {
  const Instance own = instance(plan_.seed, problem.name, run);
  const std::unique_ptr<const Objective> objective = turned(problem, own.rotation);
  RunSettings settings;
  settings.budget.evaluations = plan_.budget;
  settings.seed = own.run_seed;
  settings.domain = &domain_by_name(plan_.entries[entry].domain);
  settings.stop = std::move(stop);
  const RunRecord record = run_optimizer(*optimizers_[entry], *objective, settings);
  if (record.outcome == RunRecord::Outcome::kStopped) return std::nullopt;
  Json line = run_line(problem.name, entry, run, record);
  line["trace"] = trace_json(record, *objective);
  return line;
}

Json ComparisonWork::failed_run(const std::string& mesh, std::size_t entry, int run, const std::string& error) const {
  RunRecord record;
  record.objective = mesh;
  record.optimizer = optimizers_[entry]->name();
  record.parameters = optimizers_[entry]->parameters();
  record.domain = plan_.entries[entry].domain;
  record.seed = instance(plan_.seed, mesh, run).run_seed;
  record.outcome = RunRecord::Outcome::kFailed;
  record.error = error;
  record.incumbent.value = std::numeric_limits<double>::infinity();
  record.merit = std::nan("");
  Json line = run_line(mesh, entry, run, record);
  line["trace"] = {{"evaluations", Json::array()}, {"seconds", Json::array()}, {"merit", Json::array()}};
  return line;
}

Json take_times(Json& line) {
  Json times = Json::object();
  // The fields stay where they are, empty, so that putting the times back gives the same text.
  for (const char* key : kTimes)
    if (line.contains(key)) times[key] = std::exchange(line[key], nullptr);
  if (line.contains("trace")) times["trace"] = std::exchange(line["trace"]["seconds"], nullptr);
  return times;
}

void put_times(Json& line, const Json& times) {
  for (const char* key : kTimes)
    if (times.contains(key)) line[key] = times[key];
  if (times.contains("trace")) line["trace"]["seconds"] = times["trace"];
}

}  // namespace rectilin::laboratory
