#include "rectilin/laboratory/comparison.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>

#include "rectilin/base/batch.h"
#include "rectilin/base/folder_lock.h"
#include "rectilin/base/journal.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/provenance.h"
#include "rectilin/laboratory/report.h"
#include "rectilin/measure/measure.h"
#include "rectilin/measure/verify.h"
#include "rectilin/mesh/mesh_report.h"
#include "rectilin/mesh/source.h"
#include "turned_objective.h"

namespace rectilin::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMeshes = "meshes.jsonl";
constexpr const char* kRuns = "runs.jsonl";

void store_plan(const Plan& plan, const fs::path& folder) {
  const fs::path file = folder / "plan.json";
  std::error_code unknown;  // read_whole_file() will say what is wrong
  if (fs::status(file, unknown).type() == fs::file_type::not_found) {
    write_whole_file(file, to_text(to_json(plan), 2) + '\n');
    return;
  }
  Plan stored;
  try {
    stored = plan_from_json(Json::parse(read_whole_file(file)));
  } catch (const Json::exception&) {
    throw ParameterError(file.string() + ": is not the plan of a comparison; choose another folder");
  }
  if (stored != plan)
    throw ParameterError(folder.string() + " holds a comparison with another plan (" + difference(stored, plan) +
                         "); choose another folder or remove it");
}

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

/// How many budgets of a run the search for the best known value gets.
constexpr std::uint64_t kReferenceBudgets = 10;

/// A mesh of the plan and what is known about it.
struct Problem {
  std::string name, error;
  std::string digest;    // digest of the mesh
  std::string left_out;  // what the mesh's reader left out
  std::size_t faces = 0;
  std::optional<AreaVectors> vectors;
  std::shared_ptr<const Objective> other;  // what is searched instead of R, if the plan says so
  bool certified = false;
};

struct Task {
  const Problem* problem;
  const Entry* entry;
  const Optimizer* optimizer;
  int run;
};

class Comparison {
 public:
  Comparison(const Plan& plan, const fs::path& folder, const Registry& registry, const ComparisonSettings& settings)
      : plan_(plan),
        folder_(folder),
        settings_(settings),
        certifier_(plan.proves() ? measure_options(plan.certificate, registry) : MeasureOptions()),
        reference_(plan.proves() ? nullptr : registry.make(plan.certificate)),
        meshes_(folder / kMeshes),
        runs_(folder / kRuns) {
    for (const Entry& entry : plan.entries) optimizers_.push_back(registry.make(entry.spec));
  }

  ComparisonOutcome go(const std::vector<Json>& known_meshes, const std::vector<Json>& known_runs) {
    for (const std::string& mesh : plan_.meshes) problems_.push_back(load(mesh));
    for_each_line(folder_ / kMeshes, known_meshes, [&](const Json& line) { recall(line); });
    for_each_line(folder_ / kRuns, known_runs, [&](const Json& line) { recall_run(line); });
    plan_tasks();
    for (Problem& problem : problems_)
      if (!settings_.stop.stop_requested() && !problem.certified) certify(problem);
    run_tasks();
    outcome_.complete = progress_.done == progress_.total && std::ranges::all_of(problems_, &Problem::certified);
    return std::move(outcome_);
  }

 private:
  Problem load(const std::string& mesh) {
    Problem problem;
    problem.name = mesh;
    show("reading " + mesh);
    try {
      ComparedMesh loaded = settings_.load(mesh);
      problem.vectors = std::move(loaded.vectors);
      problem.digest = std::move(loaded.digest);
      problem.faces = loaded.faces;
      problem.left_out = std::move(loaded.left_out);
      if (!problem.left_out.empty()) outcome_.losses.push_back(mesh + ": " + problem.left_out);
      if (!plan_.proves()) problem.other = settings_.objective(mesh);
    } catch (const std::exception& e) {
      problem.error = error_about(mesh, e.what());
      outcome_.mesh_errors.push_back(problem.error);
    }
    return problem;
  }

  void recall(const Json& line) {
    for (Problem& problem : problems_) {
      if (problem.name != line.at("mesh")) continue;
      // A mesh that could not be read before is tried again.
      problem.certified = !line.contains("error") || !problem.vectors;
      if (line.contains("error")) continue;
      if (problem.vectors && line.value("mesh_digest", "") != problem.digest)
        throw ParameterError(problem.name + " has changed since the comparison began; choose another folder");
    }
  }

  void recall_run(const Json& line) {
    const std::string mesh = line.at("mesh"), entry = line.at("entry");
    if (std::ranges::find(plan_.meshes, mesh) == plan_.meshes.end() ||
        std::ranges::find(plan_.entries, entry, &Entry::label) == plan_.entries.end())
      throw std::out_of_range("a run of another comparison");
    done_.emplace(mesh, entry, line.at("run"));
    outcome_.failed_runs += line.at("outcome") == to_string(RunRecord::Outcome::kFailed);
  }

  void plan_tasks() {
    for (const Problem& problem : problems_) {
      if (!problem.vectors) continue;
      for (int run = 0; run < plan_.runs; ++run) {
        for (std::size_t i = 0; i < plan_.entries.size(); ++i) {
          ++progress_.total;
          const Task task{&problem, &plan_.entries[i], optimizers_[i].get(), run};
          if (done_.contains({problem.name, task.entry->label, run})) ++progress_.done;
          else work_left_ += work(task), tasks_.push_back(task);
        }
      }
    }
  }

  /// For objectives without proof: the best value that a search finds on the mesh as it is, in the form of the line
  /// that bounds would have.
  std::optional<Json> search_reference(const Problem& problem) const {
    RunSettings settings;
    settings.budget.evaluations = kReferenceBudgets * plan_.budget;
    settings.seed = plan_.seed;
    settings.stop = settings_.stop;
    const RunRecord record = run_optimizer(*reference_, *problem.other, settings);
    if (record.outcome == RunRecord::Outcome::kStopped) return std::nullopt;
    if (!record.error.empty()) throw std::runtime_error(problem.name + ": " + record.error);
    Json line = {{"faces", problem.faces},          {"directions", problem.vectors->size()},
                 {"area", problem.vectors->area()}, {"objective", plan_.objective},
                 {"merit", record.merit},           {"upper", nullptr}};
    line.update(to_json(record));
    return line;
  }

  /// Proves bounds of R for the mesh as it is, and writes its line.
  void certify(Problem& problem) {
    show("bounding the optimum of " + problem.name);
    Json line = {{"mesh", problem.name}};
    if (!problem.left_out.empty()) line["left_out"] = problem.left_out;
    if (problem.other) {
      const std::optional<Json> found = search_reference(problem);
      if (!found) return;
      line["mesh_digest"] = problem.digest;
      line.update(*found);
    } else if (problem.vectors) {
      MeasureOptions options = certifier_;
      options.run.seed = plan_.seed;
      options.run.stop = settings_.stop;
      options.run.on_progress = [this, &problem](const Evaluator& run) {
        show("bounding the optimum of " + problem.name + " for " + std::to_string(std::lround(run.seconds())) + " s");
      };
      Rectilinearity result = measure(ProjectedArea(*problem.vectors, problem.name), options);
      if (result.run.outcome == RunRecord::Outcome::kStopped) return;
      result.faces = problem.faces;
      line["mesh_digest"] = problem.digest;
      line.update(to_json(result));
    } else {
      line["error"] = problem.error;
    }
    meshes_.append(line);
    problem.certified = true;
  }

  void run_tasks() {
    begin_ = std::chrono::steady_clock::now();
    show("");
    // Lines are written in the order in which runs finish; the results are sorted when they are read.
    std::vector<std::string> names;
    for (const Task& task : tasks_) names.push_back(task.entry->label + " on " + task.problem->name);
    std::mutex writing;
    const auto perform = [&](std::size_t i) {
      // In an arena of one thread the loops inside a run stay on the thread that began it, so its times are its own.
      tbb::task_arena(1).execute([&] {
        const Json line = perform_run(tasks_[i]);
        const std::lock_guard lock(writing);
        if (!line.is_null()) record_run(tasks_[i], line);
      });
      return true;
    };
    const auto throw_on = [](std::size_t, Outcome<bool>&& run) {
      if (!run.value) throw std::runtime_error(run.error);  // the journal could not be written
    };
    for_each_in_order<bool>(names, perform, throw_on, {.stop = settings_.stop});
  }

  static std::unique_ptr<const Objective> turned(const Problem& problem, const Rotation& rotation) {
    if (problem.other) return std::make_unique<TurnedObjective>(problem.other, rotation);
    return std::make_unique<ProjectedArea>(rotated(*problem.vectors, rotation), problem.name);
  }

  /// Does a run and returns its line; null if it was stopped.
  Json perform_run(const Task& task) const {
    const Instance problem = instance(plan_.seed, task.problem->name, task.run);
    const std::unique_ptr<const Objective> objective = turned(*task.problem, problem.rotation);
    RunSettings settings;
    settings.budget.evaluations = plan_.budget;
    settings.seed = problem.run_seed;
    settings.domain = &domain_by_name(task.entry->domain);
    settings.stop = settings_.stop;
    const RunRecord record = run_optimizer(*task.optimizer, *objective, settings);
    if (record.outcome == RunRecord::Outcome::kStopped) return nullptr;
    Json line = {{"mesh", task.problem->name}, {"entry", task.entry->label}, {"run", task.run}};
    line.update(to_json(record));
    line["instance"] = to_json(problem.rotation);
    line["trace"] = trace_json(record, *objective);
    return line;
  }

  void record_run(const Task& task, const Json& line) {
    runs_.append(line);
    outcome_.failed_runs += line.at("outcome") == to_string(RunRecord::Outcome::kFailed);
    ++progress_.done;
    work_done_ += work(task);
    work_left_ -= work(task);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    progress_.seconds_left = elapsed / work_done_ * work_left_;
    show(task.entry->label + " on " + task.problem->name);
  }

  /// An estimate of how long a run takes, in arbitrary units: the optimizers' own work counts like some
  /// hundred directions.
  static double work(const Task& task) { return 300 + static_cast<double>(task.problem->vectors->size()); }

  void show(std::string text) {
    progress_.text = std::move(text);
    if (settings_.on_progress) settings_.on_progress(progress_);
  }

  const Plan& plan_;
  const fs::path& folder_;
  const ComparisonSettings& settings_;
  MeasureOptions certifier_;
  std::unique_ptr<Optimizer> reference_;  // takes the place of the certifier if there is no proof
  std::vector<std::unique_ptr<Optimizer>> optimizers_;
  std::vector<Problem> problems_;
  std::set<std::tuple<std::string, std::string, int>> done_;
  std::vector<Task> tasks_;
  Journal meshes_, runs_;
  ComparisonOutcome outcome_;
  ComparisonProgress progress_;
  double work_done_ = 0, work_left_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace

ComparedMesh load_compared_mesh(const std::string& source) { return compared_mesh(load_mesh(source)); }

ComparedMesh compared_mesh(const LoadedMesh& loaded) {
  const Mesh& mesh = loaded.mesh;
  return {area_vectors(mesh), mesh.triangles.size(), mesh_digest(mesh), summary(loaded.report)};
}

ComparisonOutcome run_comparison(const Plan& plan, const fs::path& folder, const Registry& registry,
                                 const ComparisonSettings& settings) {
  check(plan, registry);
  if (!plan.proves() && !settings.objective)
    throw ParameterError("the objective '" + plan.objective + "' is unknown here");
  fs::create_directories(folder);
  const FolderLock lock(folder);
  store_plan(plan, folder);
  record_start(plan, registry, folder, settings.command_line);
  const std::vector<Json> meshes = recover_journal(folder / kMeshes);
  const std::vector<Json> runs = recover_journal(folder / kRuns);
  ComparisonOutcome outcome = Comparison(plan, folder, registry, settings).go(meshes, runs);
  if (settings.report && outcome.complete) outcome.pictures = write_report(folder, lock);
  return outcome;
}

}  // namespace rectilin::laboratory
