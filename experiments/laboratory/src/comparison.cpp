#include "rectilin/laboratory/comparison.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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
#include "rectilin/laboratory/work.h"

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
    stored = plan_from_json(parse_json(read_whole_file(file)));
  } catch (const Json::exception&) {
    throw ParameterError(file.string() + ": is not the plan of a comparison; choose another folder");
  }
  if (stored != plan)
    throw ParameterError(folder.string() + " holds a comparison with another plan (" + difference(stored, plan) +
                         "); choose another folder or remove it");
}

/// A mesh of the plan and what is known about it.
struct PlannedMesh {
  std::string name, error;
  std::optional<Problem> problem;  // none if it cannot be read
  bool certified = false;
};

struct Task {
  const Problem* problem;
  std::size_t entry;
  int run;
};

class Comparison {
 public:
  Comparison(const Plan& plan, const fs::path& folder, const Registry& registry, const ComparisonSettings& settings)
      : plan_(plan),
        folder_(folder),
        settings_(settings),
        work_(plan, registry),
        meshes_(folder / kMeshes),
        runs_(folder / kRuns) {}

  ComparisonOutcome go(const std::vector<Json>& known_meshes, const std::vector<Json>& known_runs) {
    for (const std::string& mesh : plan_.meshes) problems_.push_back(load(mesh));
    for_each_line(folder_ / kMeshes, known_meshes, [&](const Json& line) { recall(line); });
    for_each_line(folder_ / kRuns, known_runs, [&](const Json& line) { recall_run(line); });
    plan_tasks();
    for (PlannedMesh& mesh : problems_)
      if (!settings_.stop.stop_requested() && !mesh.certified) certify(mesh);
    run_tasks();
    outcome_.complete = progress_.done == progress_.total && std::ranges::all_of(problems_, &PlannedMesh::certified);
    return std::move(outcome_);
  }

 private:
  PlannedMesh load(const std::string& name) {
    PlannedMesh mesh{name, {}, {}, false};
    show("reading " + name);
    try {
      Problem problem{name, settings_.load(name)};
      if (!problem.mesh.left_out.empty()) outcome_.losses.push_back(name + ": " + problem.mesh.left_out);
      if (!plan_.proves()) problem.other = settings_.objective(name);
      mesh.problem = std::move(problem);
    } catch (const std::exception& e) {
      mesh.error = error_about(name, e.what());
      outcome_.mesh_errors.push_back(mesh.error);
    }
    return mesh;
  }

  void recall(const Json& line) {
    for (PlannedMesh& mesh : problems_) {
      if (mesh.name != line.at("mesh")) continue;
      // A mesh that could not be read before is tried again.
      mesh.certified = !line.contains("error") || !mesh.problem;
      if (line.contains("error")) continue;
      if (mesh.problem && line.value("mesh_digest", "") != mesh.problem->mesh.digest)
        throw ParameterError(mesh.name + " has changed since the comparison began; choose another folder");
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
    for (const PlannedMesh& mesh : problems_) {
      if (!mesh.problem) continue;
      for (int run = 0; run < plan_.runs; ++run) {
        for (std::size_t i = 0; i < plan_.entries.size(); ++i) {
          ++progress_.total;
          const Task task{&*mesh.problem, i, run};
          if (done_.contains({mesh.name, plan_.entries[i].label, run})) ++progress_.done;
          else work_left_ += work(task), tasks_.push_back(task);
        }
      }
    }
  }

  /// Proves bounds of R for the mesh as it is, and writes its line.
  void certify(PlannedMesh& mesh) {
    const std::string what = "bounding the optimum of " + mesh.name;
    show(what);
    std::optional<Json> line = ComparisonWork::unmeasured(mesh.name, mesh.error);
    if (mesh.problem)
      line = work_.bound(*mesh.problem, settings_.stop, [&](const Evaluator& run) {
        show(what + " for " + std::to_string(std::lround(run.seconds())) + " s");
      });
    if (!line) return;
    meshes_.append(*line);
    mesh.certified = true;
  }

  void run_tasks() {
    begin_ = std::chrono::steady_clock::now();
    show("");
    // Lines are written in the order in which runs finish; the results are sorted when they are read.
    std::vector<std::string> names;
    for (const Task& task : tasks_) names.push_back(name_of(task));
    std::mutex writing;
    const auto perform = [&](std::size_t i) {
      // In an arena of one thread the loops inside a run stay on the thread that began it, so its times are its own.
      tbb::task_arena(1).execute([&] {
        const Task& task = tasks_[i];
        const std::optional<Json> line = work_.run(*task.problem, task.entry, task.run, settings_.stop);
        const std::lock_guard lock(writing);
        if (line) record_run(task, *line);
      });
      return true;
    };
    const auto throw_on = [](std::size_t, Outcome<bool>&& run) {
      if (!run.value) throw std::runtime_error(run.error);  // the journal could not be written
    };
    for_each_in_order<bool>(names, perform, throw_on, {.stop = settings_.stop});
  }

  std::string name_of(const Task& task) const { return plan_.entries[task.entry].label + " on " + task.problem->name; }

  void record_run(const Task& task, const Json& line) {
    runs_.append(line);
    outcome_.failed_runs += line.at("outcome") == to_string(RunRecord::Outcome::kFailed);
    ++progress_.done;
    work_done_ += work(task);
    work_left_ -= work(task);
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    progress_.seconds_left = elapsed / work_done_ * work_left_;
    show(name_of(task));
  }

  /// An estimate of how long a run takes, in arbitrary units: the optimizers' own work counts like some
  /// hundred directions.
  static double work(const Task& task) { return 300 + static_cast<double>(task.problem->mesh.vectors.size()); }

  void show(std::string text) {
    progress_.text = std::move(text);
    if (settings_.on_progress) settings_.on_progress(progress_);
  }

  const Plan& plan_;
  const fs::path& folder_;
  const ComparisonSettings& settings_;
  const ComparisonWork work_;
  std::vector<PlannedMesh> problems_;
  std::set<std::tuple<std::string, std::string, int>> done_;
  std::vector<Task> tasks_;
  Journal meshes_, runs_;
  ComparisonOutcome outcome_;
  ComparisonProgress progress_;
  double work_done_ = 0, work_left_ = 0;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace

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

report::PictureTroubles write_comparison(const Plan& plan, const fs::path& folder, const Registry& registry,
                                         const std::string& command_line, const std::vector<Json>& meshes,
                                         const std::vector<Json>& runs) {
  check(plan, registry);
  fs::create_directories(folder);
  const FolderLock lock(folder);
  store_plan(plan, folder);
  const auto key = [](const Json& line) {
    return std::tuple(line.at("mesh").get<std::string>(), line.at("entry").get<std::string>(),
                      line.at("run").get<int>());
  };
  std::set<std::tuple<std::string, std::string, int>> known;
  for (const Json& line : runs) known.insert(key(line));
  for_each_line(folder / kRuns, recover_journal(folder / kRuns), [&](const Json& line) {
    if (!known.contains(key(line)))
      throw ParameterError(folder.string() + " holds runs that the store does not have; choose another folder");
  });
  record_start(plan, registry, folder, command_line);
  for (const auto& [name, lines] : {std::pair(kMeshes, &meshes), std::pair(kRuns, &runs)}) {
    std::string text;
    for (const Json& line : *lines) text += to_text(line) + '\n';
    write_whole_file(folder / name, text);
  }
  return write_report(folder, lock);
}

}  // namespace rectilin::laboratory
