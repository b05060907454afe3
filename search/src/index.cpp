#include "rectilin/search/index.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "found_files.h"
#include "rectilin/base/printable.h"
#include "rectilin/mesh/source.h"
#include "rectilin/search/describe.h"
#include "rectilin/search/digest.h"
#include "rectilin/search/index_worker.h"

namespace rectilin::search {
namespace {

namespace fs = std::filesystem;

/// A file to be described.
struct IndexJob {
  Member member;
  std::string error;      ///< why it cannot be
  bool is_known = false;  ///< it was described before, when it was another
};

class IndexUpdate final : public corpus::JobHandler {
 public:
  IndexUpdate(Database& database, const IndexOptions& options)
      : database_(database), options_(options), terms_(make_terms(database.descriptor())) {
    for (const fs::path& file : options.done) {
      done_.emplace_back(file);
      if (done_.back().descriptor() != database.descriptor())
        throw ParameterError(file.string() + ": holds signatures of '" + done_.back().descriptor() + "', not of '" +
                             database.descriptor() + "'");
    }
  }

  IndexSummary run(const std::vector<std::string>& sources, const LoopControl& control) {
    std::vector<FoundFile> found = find_files(sources);
    std::set<std::string> present;
    for (const FoundFile& f : found) present.insert(f.member.source);
    plan(digested(std::move(found), options_.shard), present, sources);
    describe(control);
    for (auto& [name, error] : errors_) summary_.errors.push_back(std::move(error));
    return std::move(summary_);
  }

 private:
  /// What is there, what moved, what is gone: all at once, so that a name is never taken twice.
  void plan(std::vector<FoundFile> found, const std::set<std::string>& present,
            const std::vector<std::string>& sources) {
    std::erase_if(found, [this](const FoundFile& f) { return is_elsewhere(f.member); });
    std::set<std::string> own;
    for (const FoundFile& f : found) own.insert(f.member.source);
    for (Member& member : database_.members()) {
      names_.insert(member.name);
      by_source_.emplace(member.source, std::move(member));
    }
    database_.begin();
    find_gone(present, own, sources);
    for (FoundFile& f : found) look_at(std::move(f));
    for (const auto& [id, member] : gone_) {
      database_.remove(id);
      if (member.status != MemberStatus::kLeft) ++summary_.removed;
    }
    // New files have rows from now on, so that a database tells how far it is, and ids that do not depend on the order
    // in which they are done.
    for (IndexJob& job : jobs_)
      if (job.member.id == 0) job.member.id = database_.put(job.member, nullptr);
    database_.begin_run(options_.shard.to_string());
    database_.commit();
  }

  bool is_elsewhere(const Member& member) {
    for (Database& other : done_) {
      const auto known = other.find(member.name);
      if (known && !member.digest.empty() && known->digest == member.digest &&
          (known->status == MemberStatus::kDone || (known->status == MemberStatus::kFailed && !options_.retry))) {
        ++summary_.elsewhere;
        return true;
      }
    }
    return false;
  }

  void find_gone(const std::set<std::string>& present, const std::set<std::string>& own,
                 const std::vector<std::string>& sources) {
    std::vector<std::string> tops;
    for (const std::string& source : sources) tops.push_back(from_root(source));
    for (const auto& [source, member] : by_source_) {
      const bool within = std::ranges::any_of(tops, [&](const std::string& top) { return is_within(source, top); });
      if (own.contains(source)) continue;
      if (member.status == MemberStatus::kLeft) {  // left by a run on other shards or files
        gone_.emplace(member.id, member);
        continue;
      }
      // In another shard, or outside of what is looked at: there only a file that is not there any more can have moved.
      if (present.contains(source) || (!within && (is_shape_source(source) || fs::exists(file_of(source))))) {
        if (member.status == MemberStatus::kDone) stays(member, member.digest);
        continue;
      }
      if (!member.digest.empty()) gone_by_digest_[member.digest].push_back(member);
      if (within) gone_.emplace(member.id, member);
    }
  }

  void look_at(FoundFile found) {
    Member& own = found.member;
    bool is_known = false;
    if (const auto known = by_source_.find(own.source); known != by_source_.end()) {
      const Member& old = known->second;
      own.id = old.id;
      own.name = old.name;
      is_known = old.status != MemberStatus::kLeft;
      const bool again = old.status == MemberStatus::kFailed && options_.retry;
      if (is_known && !again && old.digest == own.digest && !own.digest.empty()) {
        if (old.status == MemberStatus::kFailed) errors_.emplace(old.name, old.error);
        if (old.status == MemberStatus::kDone) stays(own, own.digest);
        ++summary_.unchanged;
        return;
      }
    } else {
      const auto moved = gone_by_digest_.find(own.digest);
      const bool has_moved = !own.digest.empty() && moved != gone_by_digest_.end() && !moved->second.empty();
      const Member old = has_moved ? moved->second.back() : Member();
      if (has_moved) {
        moved->second.pop_back();
        own.id = old.id;
        gone_.erase(old.id);
      }
      if (old.status == MemberStatus::kDone) names_.erase(old.name);
      if (names_.contains(own.name)) own.name = own.source;
      names_.insert(own.name);
      if (old.status == MemberStatus::kDone) {
        database_.rename(own);
        stays(own, own.digest);
        ++summary_.moved;
        return;
      }
      is_known = has_moved;
    }
    jobs_.push_back({std::move(own), std::move(found.error), is_known});
  }

  /// A member whose row stays as it is; files with the same bytes can take its signature.
  void stays(const Member& member, const std::string& digest) {
    if (!digest.empty()) by_digest_.emplace(digest, member.id);
  }

  void describe(const LoopControl& control) {
    std::map<std::string, std::size_t> first;  // of the files with the same bytes, by digest
    std::vector<NamedSource> to_do;
    for (std::size_t k = 0; k < jobs_.size(); ++k) {
      const Member& member = jobs_[k].member;
      if (member.digest.empty()) fail(k, jobs_[k].error);
      else if (by_digest_.contains(member.digest)) copy(k);
      else if (const auto [same, is_first] = first.emplace(member.digest, k); !is_first)
        copies_[same->second].push_back(k);
      else {
        to_do.push_back({member.name, member.source, {}});
        index_of_.push_back(k);
      }
    }
    if (options_.workers) {
      const corpus::Task task{kIndexTask, {{"descriptor", database_.descriptor()}}};
      corpus::run_jobs(to_do, task, *options_.workers, nullptr, *this, control);
    } else {
      std::vector<std::string> sources;
      for (const NamedSource& source : to_do) sources.push_back(source.source);
      for_each_in_order<DescribedMesh>(
          sources, [&](std::size_t i) { return describe_source(sources[i], terms_); },
          [&](std::size_t i, Outcome<DescribedMesh>&& outcome) { take(index_of_[i], std::move(outcome)); }, control);
    }
    summary_.complete = finished_ == jobs_.size();
  }

  void finish(std::size_t i, corpus::Answer&& answer) override {
    const std::size_t k = index_of_[i];
    Outcome<DescribedMesh> outcome;
    if (answer.status == corpus::RowStatus::kDone) outcome.value = described_mesh(answer, terms_);
    else outcome.error = error_about(jobs_[k].member.source, answer.error);
    take(k, std::move(outcome));
  }

  /// Puts what was described into the database, and copies of the same bytes.
  void take(std::size_t k, Outcome<DescribedMesh>&& outcome) {
    if (!outcome.value) {
      fail(k, printable(outcome.error));
    } else {
      Member& made = outcome.value->member;
      const Member& own = jobs_[k].member;
      made.id = own.id;
      made.name = own.name;
      made.source = own.source;
      made.digest = own.digest;
      ++(jobs_[k].is_known ? summary_.changed : summary_.added);
      put(made, &outcome.value->parts);
    }
    for (const std::size_t same : copies_[k]) copy(same);
  }

  /// Takes the row of another file with the same bytes, which is done or has failed.
  void copy(std::size_t k) {
    const Member& own = jobs_[k].member;
    Member same = *database_.find_id(by_digest_.at(own.digest));
    if (same.status == MemberStatus::kFailed) return fail(k, same.error);
    const Parts parts = database_.signature(same.id);
    same.id = own.id;
    same.name = own.name;
    same.source = own.source;
    ++summary_.copied;
    put(same, &parts);
  }

  void fail(std::size_t k, const std::string& error) {
    Member member = jobs_[k].member;
    member.status = MemberStatus::kFailed;
    member.error = error;
    errors_.emplace(member.name, error);
    put(member, nullptr);
  }

  void put(const Member& member, const Parts* parts) {
    stays(member, member.digest);
    database_.put(member, parts);
    ++finished_;
  }

  Database& database_;
  const IndexOptions& options_;
  const std::vector<retrieval::DescriptorPointer> terms_;
  std::vector<Database> done_;
  IndexSummary summary_;
  std::map<std::string, std::string> errors_;  ///< by the members' names

  std::map<std::string, Member> by_source_;
  std::set<std::string> names_;
  std::map<std::string, std::vector<Member>> gone_by_digest_;
  std::map<std::int64_t, Member> gone_;
  std::map<std::string, std::int64_t> by_digest_;  ///< members that are done or have failed, by their files' digests

  std::vector<IndexJob> jobs_;
  std::vector<std::size_t> index_of_;                       ///< those that are described, of all jobs
  std::map<std::size_t, std::vector<std::size_t>> copies_;  ///< jobs with the same bytes as one that is described
  std::size_t finished_ = 0;
};

}  // namespace

IndexSummary update_index(Database& database, const std::vector<std::string>& sources, const LoopControl& control,
                          const IndexOptions& options) {
  return IndexUpdate(database, options).run(sources, control);
}

}  // namespace rectilin::search
