// Runs the tests of claims on meshes and on the claims' own shapes.
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>

#include "claims/retrieval.h"
#include "claims/tests.h"
#include "rectilin/base/batch.h"
#include "rectilin/base/factory.h"
#include "rectilin/base/fnv1a.h"
#include "rectilin/mesh/source.h"
#include "rectilin/paper/claims.h"

namespace rectilin::paper {
namespace {

using namespace claims;

/// A stream of random numbers for a claim and a mesh that does not depend on what else is tested.
Random stream(std::uint64_t seed, std::string_view claim, std::string_view source) {
  return Random(seed).fork(Fnv1a().add(claim).add("\n").add(source).value());
}

struct Job {
  const Claim* claim;
  const ClaimTest* test;
};

std::vector<Job> jobs_for(const std::vector<std::string>& wanted) {
  std::vector<std::string> known;
  for (const Claim& claim : all_claims()) known.push_back(claim.id);
  for (const std::string& id : wanted)
    if (std::ranges::find(known, id) == known.end()) throw_unknown_name("claim", id, known);
  std::vector<Job> jobs;
  for (const Claim& claim : all_claims()) {
    if (!wanted.empty() && std::ranges::find(wanted, claim.id) == wanted.end()) continue;
    const auto test = std::ranges::find(claim_tests(), claim.id, &ClaimTest::claim);
    if (test == claim_tests().end()) throw std::logic_error("claim " + claim.id + " has no test");
    jobs.push_back({&claim, &*test});
  }
  return jobs;
}

/// Collects the findings of a claim and, in the end, picks the decisive one.
class Tally {
 public:
  void add(Finding finding) {
    // Only the worst finding needs its mesh, which may be large.
    if (!findings_.empty() && findings_[worst_].margin <= finding.margin) finding.mesh.reset();
    else if (!findings_.empty()) findings_[worst_].mesh.reset(), worst_ = findings_.size();
    findings_.push_back(std::move(finding));
  }

  ClaimResult conclude(const Claim& claim, double quantile) {
    ClaimResult result;
    result.claim = &claim;
    result.tested = findings_.size();
    if (findings_.empty()) return result;
    result.failed = static_cast<std::size_t>(
        std::ranges::count_if(findings_, [&](const Finding& f) { return f.margin < -claim.tolerance; }));
    std::ranges::stable_sort(findings_, {}, &Finding::margin);
    result.decisive = findings_[static_cast<std::size_t>(quantile * static_cast<double>(findings_.size()))];
    const double margin = result.decisive.margin;
    result.verdict = margin < -claim.tolerance   ? ClaimVerdict::kFails
                     : margin <= claim.tolerance ? ClaimVerdict::kHolds
                                                 : ClaimVerdict::kHoldsWithMargin;
    return result;
  }

 private:
  std::vector<Finding> findings_;
  std::size_t worst_ = 0;
};

class Run {
 public:
  Run(const std::vector<std::string>& sources, const ValidationSettings& settings)
      : settings_(settings), jobs_(jobs_for(settings.claims)), tallies_(jobs_.size()) {
    if (std::ranges::any_of(jobs_, [](const Job& job) { return job.test->on_mesh != nullptr; })) sources_ = sources;
    steps_ = sources_.size() + jobs_.size();
  }

  Validation go() {
    test_shapes();
    test_collection();
    test_meshes();
    validation_.losses = losses_.lines();
    validation_.complete = !settings_.stop.stop_requested();
    for (std::size_t i = 0; i < jobs_.size(); ++i)
      validation_.results.push_back(tallies_[i].conclude(*jobs_[i].claim, jobs_[i].test->quantile));
    return std::move(validation_);
  }

 private:
  /// The findings on one mesh, one for each job that applies to it.
  using Findings = std::vector<std::optional<Finding>>;

  void test_shapes() {
    tbb::parallel_for(std::size_t{0}, jobs_.size(), [&](std::size_t i) {
      if (settings_.stop.stop_requested()) return;
      const Job& job = jobs_[i];
      if (job.test->on_shapes) {
        tbb::this_task_arena::isolate([&] {
          for (Finding& finding : job.test->on_shapes(stream(settings_.seed, job.claim->id, {})))
            tallies_[i].add(std::move(finding));
        });
      }
      step(job.claim->id);
    });
  }

  /// All rows that the claims need are computed together, so that each signature is computed once.
  void test_collection() {
    if (settings_.collection.empty() != settings_.classes.empty())
      throw ParameterError("a collection and its classes are needed together, or neither");
    std::vector<tables::Row> rows;
    for (const Job& job : jobs_) {
      if (job.test->rows == nullptr) continue;
      for (tables::Row& row : job.test->rows())
        if (std::ranges::find(rows, row.label, &tables::Row::label) == rows.end()) rows.push_back(std::move(row));
    }
    if (settings_.collection.empty() || rows.empty() || settings_.stop.stop_requested()) return;
    const tables::TableSettings settings{
        .folder = settings_.collection, .classes = settings_.classes, .cache = settings_.cache, .size = settings_.size};
    ExperimentContext context{.seed = settings_.seed, .stop = settings_.stop, .on_progress = settings_.on_progress};
    try {
      tables::ScoredTable table = tables::score(rows, settings, context);
      validation_.errors.insert(validation_.errors.end(), table.errors.begin(), table.errors.end());
      const TestCollection collection(std::move(table));
      for (std::size_t i = 0; i < jobs_.size(); ++i)
        if (jobs_[i].test->on_collection != nullptr)
          for (Finding& finding : jobs_[i].test->on_collection(collection)) tallies_[i].add(std::move(finding));
    } catch (const Stopped&) {  // the claims stay untested
    }
  }

  void test_meshes() {
    // Delivered in order, so that which of several equal findings comes first does not depend on threads.
    const auto keep = [&](std::size_t i, Outcome<Findings>&& outcome) {
      if (!outcome.value) validation_.errors.push_back(outcome.error);
      else
        for (std::size_t k = 0; k < outcome.value->size(); ++k)
          if ((*outcome.value)[k]) tallies_[k].add(std::move(*(*outcome.value)[k]));
      step(sources_[i]);
    };
    for_each_in_order<Findings>(sources_, [&](std::size_t i) { return test_mesh(sources_[i]); }, keep,
                                {.stop = settings_.stop});
  }

  Findings test_mesh(const std::string& source) {
    const TestMesh mesh = make_test_mesh(source, &losses_);
    Findings findings;
    for (const Job& job : jobs_)
      findings.push_back(job.test->on_mesh ? job.test->on_mesh(mesh, stream(settings_.seed, job.claim->id, source))
                                           : std::nullopt);
    return findings;
  }

  void step(const std::string& what) {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (settings_.on_progress) settings_.on_progress(done_, steps_, what);
  }

  const ValidationSettings& settings_;
  std::vector<Job> jobs_;
  std::vector<std::string> sources_;
  std::vector<Tally> tallies_;
  Validation validation_;
  LossLog losses_;
  std::size_t done_ = 0, steps_ = 0;
  std::mutex mutex_;
};

}  // namespace

bool Validation::as_expected() const {
  return std::ranges::none_of(results, [](const ClaimResult& result) {
    return result.claim->should_hold && result.verdict == ClaimVerdict::kFails;
  });
}

Validation validate(const std::vector<std::string>& sources, const ValidationSettings& settings) {
  return Run(sources.empty() ? validation_shapes() : expand_folders(sources), settings).go();
}

const std::vector<std::string>& validation_shapes() {
  static const std::vector<std::string> shapes{
      "shape:box",
      "shape:box?x=2&y=0.3&rotate=random&seed=2",
      "shape:lshape?rotate=random&seed=3",
      "shape:stairs?steps=7&rotate=random&seed=4",
      "shape:stepped-pyramid?rotate=random&seed=5",
      "shape:pyramid",
      "shape:pyramid?height=0.4&rotate=random&seed=6",
      "shape:prism?sides=3&rotate=random&seed=7",
      "shape:prism?sides=5&caps=false",
      "shape:prism?sides=8&height=3",
      "shape:cylinder?rotate=random&seed=8",
      "shape:cut-cube",
      "shape:filleted-cube?rotate=random&seed=9",
      "shape:sphere?subdivisions=0",
      "shape:sphere?subdivisions=3",
      "shape:ellipsoid?faces=2000",
      "shape:torus?rotate=random&seed=10",
      "shape:blob?faces=5000",
      "shape:box?faces=2000&noise=0.001&rotate=random&seed=11",
      "shape:soup?faces=1",
      "shape:soup?faces=300&seed=12",
  };
  return shapes;
}

}  // namespace rectilin::paper
