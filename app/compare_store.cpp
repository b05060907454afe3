#include "compare_store.h"

#include <charconv>
#include <iostream>
#include <optional>

#include "rectilin/base/printable.h"
#include "rectilin/corpus/store.h"
#include "rectilin/laboratory/comparison.h"
#include "rectilin/laboratory/work.h"
#include "rectilin/optim/adapters/all_optimizers.h"
#include "rectilin/pose/summed_silhouette.h"
#include "terminal.h"

namespace rectilin::app {
namespace {

using laboratory::Plan;

constexpr double kSilhouetteWidth = 1e-7;  // relative, to which silhouettes are computed
constexpr std::string_view kColumn = " | ";

std::string bounds_name(const std::string& mesh) { return mesh + std::string(kColumn) + "bounds"; }

std::string run_name(const std::string& mesh, const std::string& label, int run) {
  return mesh + std::string(kColumn) + label + std::string(kColumn) + std::to_string(run + 1);
}

/// The run of a job, from 0; none for bounds.
std::optional<int> run_of(const NamedSource& job) {
  if (job.group.empty()) return std::nullopt;
  const std::string_view number = std::string_view(job.name).substr(job.name.rfind(kColumn) + kColumn.size());
  int run = 0;
  std::from_chars(number.data(), number.data() + number.size(), run);
  return run - 1;
}

std::size_t entry_of(const Plan& plan, const std::string& label) {
  const auto entry = std::ranges::find(plan.entries, label, &laboratory::Entry::label);
  if (entry == plan.entries.end()) throw ParameterError("no optimizer '" + label + "' in the plan");
  return static_cast<std::size_t>(entry - plan.entries.begin());
}

/// Does the jobs of a comparison, of which many in a row are about one mesh.
class CompareWorker {
 public:
  explicit CompareWorker(const Plan& plan) : work_(plan, all_optimizers()) {}

  corpus::WorkResult operator()(const NamedSource& job, const LoadedMesh& loaded) {
    if (!problem_ || problem_->name != job.source) {
      problem_.emplace(laboratory::Problem{job.source, laboratory::compared_mesh(loaded)});
      if (!work_.plan().proves()) problem_->other = other_objective(loaded, job.source);
    }
    const std::optional<int> run = run_of(job);
    std::optional<Json> line =
        run ? work_.run(*problem_, entry_of(work_.plan(), job.group), *run) : work_.bound(*problem_);
    Json times = laboratory::take_times(*line);
    (*line)["times"] = std::move(times);
    return {std::move(*line)};
  }

 private:
  laboratory::ComparisonWork work_;
  std::optional<laboratory::Problem> problem_;
};

/// The lines of a folder from the rows of a store.
class StoredComparison {
 public:
  StoredComparison(corpus::Store& store, const Plan& plan) : store_(store), plan_(plan), work_(plan, all_optimizers()) {
    for (const std::string& mesh : plan.meshes) take_mesh(mesh);
  }

  std::vector<Json> meshes, runs;
  std::vector<std::string> mesh_errors;
  std::size_t failed = 0, left = 0;

 private:
  static Json line_of(const corpus::Row& row) {
    Json line = parse_json(row.result);
    const Json report = parse_json(row.report.empty() ? "{}" : row.report);
    if (report.contains("times")) laboratory::put_times(line, report["times"]);
    return line;
  }

  void take_mesh(const std::string& mesh) {
    const auto bounds = store_.find(bounds_name(mesh));
    std::string digest;
    if (!bounds || bounds->status == corpus::RowStatus::kLeft) {
      ++left;
    } else if (bounds->status == corpus::RowStatus::kDone) {
      meshes.push_back(line_of(*bounds));
      digest = bounds->digest;
    } else {
      const std::string error = error_about(mesh, bounds->error);
      meshes.push_back(laboratory::ComparisonWork::unmeasured(mesh, error));
      mesh_errors.push_back(error);
      return;  // as in a comparison without a store, there are no runs
    }
    for (std::size_t entry = 0; entry < plan_.entries.size(); ++entry)
      for (int run = 0; run < plan_.runs; ++run) take_run(mesh, entry, run, digest);
  }

  void take_run(const std::string& mesh, std::size_t entry, int run, std::string& digest) {
    const auto row = store_.find(run_name(mesh, plan_.entries[entry].label, run));
    if (!row || row->status == corpus::RowStatus::kLeft) {
      ++left;
      return;
    }
    if (row->status != corpus::RowStatus::kDone) {
      ++failed;
      runs.push_back(work_.failed_run(mesh, entry, run, row->error));
      return;
    }
    if (digest.empty()) digest = row->digest;
    if (row->digest != digest) throw ParameterError(mesh + " has changed since the comparison began");
    runs.push_back(line_of(*row));
    failed += runs.back().at("outcome") == to_string(RunRecord::Outcome::kFailed);
  }

  corpus::Store& store_;
  const Plan& plan_;
  laboratory::ComparisonWork work_;
};

}  // namespace

std::shared_ptr<const Objective> other_objective(const LoadedMesh& loaded, const std::string& name) {
  return std::make_shared<pose::SummedSilhouette>(loaded.mesh, kSilhouetteWidth, name);
}

corpus::Task compare_task(const Plan& plan) { return {kCompareTask, to_json(plan)}; }

std::vector<NamedSource> compare_jobs(const Plan& plan) {
  std::vector<NamedSource> jobs;
  for (const std::string& mesh : plan.meshes) {
    jobs.push_back({bounds_name(mesh), mesh, {}});
    for (int run = 0; run < plan.runs; ++run)
      for (const laboratory::Entry& entry : plan.entries)
        jobs.push_back({run_name(mesh, entry.label, run), mesh, entry.label});
  }
  return jobs;
}

corpus::Work compare_work(const Json& settings) {
  return [worker = std::make_shared<CompareWorker>(laboratory::plan_from_json(settings))](
             const NamedSource& job, const LoadedMesh& loaded) { return (*worker)(job, loaded); };
}

int compare_from_store(const std::string& file, const std::string& folder, const std::string& command_line) {
  corpus::Store store(file);
  const corpus::Task task = store.task();
  if (task.name != kCompareTask)
    throw ParameterError(file + ": holds results of '" + task.name + "', not of '" + kCompareTask + "'");
  const Plan plan = laboratory::plan_from_json(task.settings);
  const StoredComparison stored(store, plan);
  const report::PictureTroubles pictures =
      laboratory::write_comparison(plan, folder, all_optimizers(), command_line, stored.meshes, stored.runs);
  for (const std::string& error : stored.mesh_errors) complain(error);
  for (const std::string& trouble : pictures.lines) complain(trouble);
  if (stored.failed > 0) complain(std::to_string(stored.failed) + " runs failed; the page lists them");
  if (stored.left > 0) complain(std::to_string(stored.left) + " rows of the plan are not in the store yet");
  std::cout << printable(folder) << "/index.html\n";
  return stored.mesh_errors.empty() && stored.left == 0 && !pictures.failed ? 0 : 1;
}

}  // namespace rectilin::app
