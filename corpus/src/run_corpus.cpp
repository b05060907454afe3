#include "rectilin/corpus/run_corpus.h"

#include <chrono>
#include <map>
#include <optional>

#include "rectilin/base/version.h"

namespace rectilin::corpus {
namespace {

double unix_time() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// A mesh's row, filled in so far, with what was left out of it.
struct PartialRow {
  Row row;
  std::string left_out;
};

/// Puts the rows of jobs into a store.
class StoreFiller final : public JobHandler {
 public:
  StoreFiller(std::span<const NamedSource> jobs, Store& store, const CorpusOptions& options)
      : jobs_(jobs), store_(store), options_(options), is_over_(jobs.size()) {
    if (!options.share) return;
    const std::vector<std::string> done = store.digests();
    claims_.emplace(Claims::make(done.size() + jobs.size()));
    for (const std::string& digest : done) claims_->claim(digest, Claims::kDone);
  }

  /// Nothing if each mesh is done whether it is like another or not.
  const Claims* claims() const { return claims_ ? &*claims_ : nullptr; }

  CorpusSummary summary() const {
    CorpusSummary summary = summary_;
    summary.left = jobs_.size() - summary.done - summary.failed - summary.limited;
    return summary;
  }

  void read(std::size_t job, const Json& about) override { partial_[job] = row_of(job, about); }

  bool is_wanted(std::size_t job, const Json& about) override {
    PartialRow partial = row_of(job, about);
    const std::string& digest = partial.row.digest;
    if (const auto same = store_.find_digest(digest)) {
      partial.row.result = same->result;
      ++summary_.copied;
      put(partial, RowStatus::kDone, {});
      is_over_[job] = true;
      return false;
    }
    const std::uint64_t first = claims_->owner(digest);
    if (first < is_over_.size() && !is_over_[first]) {
      waiting_[first].push_back({job, std::move(partial)});  // another worker is doing the same mesh
      return false;
    }
    claims_->give(digest, job);  // it was tried without success
    partial_[job] = std::move(partial);
    return true;
  }

  void finish(std::size_t job, Answer&& answer) override {
    const auto known = partial_.extract(job);
    PartialRow partial = known ? std::move(known.mapped()) : begin_row(job);
    Row& row = partial.row;
    if (answer.result.contains("times")) {
      Json report = parse_json(row.report);
      report["times"] = std::move(answer.result["times"]);
      row.report = to_text(report);
      answer.result.erase("times");
    }
    if (!answer.result.is_null()) row.result = to_text(answer.result);
    row.seconds = answer.seconds;
    put(partial, answer.status, answer.error);
    is_over_[job] = true;
    if (const auto same = waiting_.extract(job))
      for (auto& [copied_job, copy] : same.mapped()) {
        copy.row.result = row.result;
        summary_.copied += answer.status == RowStatus::kDone;
        put(copy, answer.status, answer.error);
        is_over_[copied_job] = true;
      }
  }

 private:
  PartialRow row_of(std::size_t job, const Json& about) const {
    PartialRow partial = begin_row(job);
    partial.row.digest = about["digest"];
    partial.row.report = to_text(about["report"]);
    partial.left_out = about["left_out"];
    return partial;
  }

  PartialRow begin_row(std::size_t job) const {
    PartialRow partial;
    partial.row.name = jobs_[job].name;
    partial.row.source = jobs_[job].source;
    partial.row.group = jobs_[job].group;
    partial.row.version = version();
    return partial;
  }

  void put(PartialRow& partial, RowStatus status, const std::string& error) {
    Row& row = partial.row;
    row.status = status;
    row.error = error;
    row.finished = unix_time();
    store_.put(row);
    if (options_.on_row) options_.on_row(row, partial.left_out);
    (status == RowStatus::kDone ? summary_.done : status == RowStatus::kFailed ? summary_.failed : summary_.limited)++;
  }

  const std::span<const NamedSource> jobs_;
  Store& store_;
  const CorpusOptions& options_;
  std::optional<Claims> claims_;
  std::vector<bool> is_over_;                  ///< by job
  std::map<std::size_t, PartialRow> partial_;  ///< of the jobs in work that have been read
  /// Jobs with the mesh of a job in work, by that job.
  std::map<std::size_t, std::vector<std::pair<std::size_t, PartialRow>>> waiting_;
  CorpusSummary summary_;
};

}  // namespace

CorpusSummary run_corpus(std::span<const NamedSource> meshes, const Shard& shard, Store& store, const Task& task,
                         const CorpusOptions& options, const LoopControl& control) {
  std::vector<Store> done;
  for (const auto& file : options.done) {
    done.emplace_back(file);
    const Task other = done.back().task();
    if (other != task) throw ParameterError(file.string() + ": holds results of " + difference(other, task));
  }
  const auto is_done = [&](const std::string& name) {
    for (Store& other : done) {
      const auto row = other.find(name);
      if (row && (row->status == RowStatus::kDone || (row->status != RowStatus::kLeft && !options.retry))) return true;
    }
    return false;
  };
  std::vector<NamedSource> own;
  std::size_t elsewhere = 0;
  for (const NamedSource& mesh : meshes) {
    if (!shard.contains(mesh.name)) continue;
    if (is_done(mesh.name)) ++elsewhere;
    else own.push_back(mesh);
  }
  const std::vector<std::size_t> left = store.begin_run(own, shard, options.retry);
  std::vector<NamedSource> to_do;
  for (const std::size_t i : left) to_do.push_back(own[i]);
  StoreFiller filler(to_do, store, options);
  run_jobs(to_do, task, options, filler.claims(), filler, control);
  CorpusSummary summary = filler.summary();
  summary.before = elsewhere + own.size() - left.size();
  store.end_run();
  return summary;
}

}  // namespace rectilin::corpus
