#include "rectilin/evaluation/evaluation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "rectilin/base/folder_lock.h"
#include "rectilin/base/whole_file.h"
#include "rectilin/laboratory/provenance.h"
#include "rectilin/laboratory/statistics.h"
#include "rectilin/retrieval/features.h"
#include "rectilin/retrieval/lfd_files.h"
#include "rectilin/search/diffusion.h"
#include "writing.h"

namespace rectilin::evaluation {
namespace {

namespace fs = std::filesystem;
using retrieval::Classification;
using retrieval::DistanceMatrix;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Which of the classification's models take part; all of them if there are only matrices.
struct Participants {
  Classification classes;
  std::vector<bool> kept;  ///< of the whole classification's models
};

/// Rows and columns of a matrix of all models for those that are kept.
DistanceMatrix part_of(const DistanceMatrix& whole, const std::vector<bool>& kept) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) rows.push_back(i);
  DistanceMatrix part(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j) part.at(i, j) = whole.at(rows[i], rows[j]);
  return part;
}

DistanceMatrix read_foreign_matrix(const std::string& file, const Participants& who) {
  const std::size_t all = who.kept.size(), left = who.classes.models.size();
  std::error_code ignored;
  if (fs::file_size(file, ignored) == 4 * all * all && all != left)
    return part_of(retrieval::read_matrix(file, all), who.kept);
  return retrieval::read_matrix(file, left);
}

/// A model's signature from a folder of somebody else's: MODEL.art or mMODEL.art, as find_collection() has meshes.
retrieval::Signature read_foreign_lfd(const fs::path& folder, const std::string& model) {
  return retrieval::read_lfd_files(folder / (fs::exists(folder / (model + ".art")) ? model : "m" + model));
}

/// Distances, and what one takes.
void compare_signatures(Result& result, const retrieval::Descriptor& descriptor,
                        const std::vector<retrieval::Signature>& signatures) {
  result.bytes = descriptor.bytes();
  result.distance = descriptor.distance_in_words();
  result.invariant = descriptor.invariant_to();
  const std::size_t n = signatures.size();
  const Clock::time_point begin = Clock::now();
  const std::size_t sample = std::min<std::size_t>(n > 0 ? n - 1 : 0, 200);  // pairs timed on one thread
  for (std::size_t i = 0; i < sample; ++i) descriptor.distance(signatures[i], signatures[i + 1]);
  if (sample > 0) result.compare_seconds = seconds_since(begin) / static_cast<double>(sample);
  result.matrix = retrieval::symmetric_matrix(
      n, [&](std::size_t i, std::size_t j) { return descriptor.distance(signatures[i], signatures[j]); });
}

/// Scores, intervals: everything that follows from the matrix.
void score(Result& result, const Classification& classes) {
  result.scores = retrieval::evaluate(result.matrix, classes);
  std::vector<std::size_t> group;
  for (std::size_t q = 0; q < classes.models.size(); ++q)
    if (result.scores.queries[q].counts) group.push_back(classes.class_of[q]);
  for (const auto& measure : retrieval::named_measures()) {
    std::vector<double> values;
    for (const auto& query : result.scores.queries)
      if (query.counts) values.push_back(query.measures.*measure.value);
    result.intervals.push_back(values.empty() ? retrieval::Interval{} : retrieval::mean_interval(values, group));
  }
}

std::vector<Comparison> compare_all(const std::vector<Result>& results, const Classification& classes) {
  std::vector<std::vector<double>> dcg(results.size());
  std::vector<std::size_t> group;
  for (std::size_t r = 0; r < results.size(); ++r)
    for (std::size_t q = 0; q < classes.models.size(); ++q) {
      if (!results[r].scores.queries[q].counts) continue;
      dcg[r].push_back(results[r].scores.queries[q].measures.dcg);
      if (r == 0) group.push_back(classes.class_of[q]);
    }
  std::vector<Comparison> comparisons;
  if (group.empty()) return comparisons;
  std::vector<double> p;
  for (std::size_t i = 0; i < results.size(); ++i)
    for (std::size_t j = i + 1; j < results.size(); ++j) {
      comparisons.push_back({i, j, retrieval::paired_difference(dcg[i], dcg[j], group), 1});
      p.push_back(comparisons.back().difference.p);
    }
  const std::vector<double> corrected = laboratory::holm(p);
  for (std::size_t k = 0; k < p.size(); ++k) comparisons[k].corrected = corrected[k];
  return comparisons;
}

class Run {
 public:
  Run(const EvaluationPlan& plan, const fs::path& out, const EvaluationSettings& settings)
      : plan_(plan), out_(out), settings_(settings), whole_(retrieval::read_classification(plan.classes)) {}

  Evaluation go() {
    Participants who{whole_, std::vector<bool>(whole_.models.size(), true)};
    retrieval::Features features;
    features.complete = true;
    if (plan_.folder) {
      const retrieval::Collection collection = retrieval::find_collection(*plan_.folder, whole_);
      if (collection.missing.size() == whole_.models.size())
        throw std::runtime_error(plan_.folder->string() + ": holds none of the models of " + plan_.classes.string());
      evaluation_.missing = collection.missing;
      features = describe(collection);
      evaluation_.failed = features.failed;
      evaluation_.errors = features.errors;
      evaluation_.losses = features.losses;
      if (!features.complete) return std::move(evaluation_);
      who = leave_out_failed(collection, features);
    }
    name_classes(who.classes);
    for (const Contestant& contestant : plan_.contestants) {
      if (settings_.stop.stop_requested()) return std::move(evaluation_);
      show("distances by " + contestant.label);
      evaluation_.results.push_back(made(contestant, features, who));
      write_result(out_, evaluation_.results.back(), who.classes);
      if (!plan_.by_collection) continue;
      show(contestant.label + " by the collection");
      evaluation_.results.push_back(by_collection(evaluation_.results.back()));
      write_result(out_, evaluation_.results.back(), who.classes);
    }
    show("scores");
    for (Result& result : evaluation_.results) score(result, who.classes);
    evaluation_.comparisons = compare_all(evaluation_.results, who.classes);
    evaluation_.classes = std::move(who.classes);
    evaluation_.complete = true;
    return std::move(evaluation_);
  }

 private:
  void show(const std::string& text) {
    if (settings_.on_progress) settings_.on_progress(total_, total_, std::numeric_limits<double>::infinity(), text);
  }

  retrieval::Features describe(const retrieval::Collection& collection) {
    std::set<std::string> specs;
    for (const Contestant& c : plan_.contestants) {
      if (c.kind != Contestant::Kind::kDescriptor) continue;
      for (const retrieval::Term& term : retrieval::parse_composite(c.text)) specs.insert(term.spec);
    }
    const Clock::time_point begin = Clock::now();
    LoopControl control{settings_.stop, [&](std::size_t done, std::size_t total, const std::string& text) {
                          total_ = total;
                          if (!settings_.on_progress) return;
                          const double left = done == 0 ? std::numeric_limits<double>::infinity()
                                                        : seconds_since(begin) * static_cast<double>(total - done) /
                                                              static_cast<double>(done);
                          settings_.on_progress(done, total, left, text);
                        }};
    return retrieval::compute_features(collection, {specs.begin(), specs.end()}, out_ / "features", control);
  }

  /// Models that failed leave the classification and the tables of signatures.
  Participants leave_out_failed(const retrieval::Collection& collection, retrieval::Features& features) const {
    const std::set<std::string> failed(features.failed.begin(), features.failed.end());
    const std::set<std::string> missing(collection.missing.begin(), collection.missing.end());
    Participants who;
    for (const std::string& model : whole_.models)
      who.kept.push_back(!failed.contains(model) && !missing.contains(model));
    who.classes = whole_.subset(who.kept);
    for (auto& [spec, table] : features.tables) {
      std::vector<retrieval::Signature> left;
      for (std::size_t i = 0; i < table.signatures.size(); ++i)
        if (!failed.contains(collection.classes.models[i])) left.push_back(std::move(table.signatures[i]));
      table.signatures = std::move(left);
    }
    return who;
  }

  void name_classes(const Classification& classes) {
    evaluation_.empty_classes = retrieval::empty_classes(classes);
    for (std::size_t c = 0; c < classes.classes.size(); ++c)
      if (const std::size_t n = classes.classes[c].models.size(); n == 1 || n == 2)
        evaluation_.small_classes.push_back(classes.path(c));
  }

  Result made(const Contestant& contestant, const retrieval::Features& features, const Participants& who) const {
    switch (contestant.kind) {
      case Contestant::Kind::kMatrix: {
        Result result{.contestant = contestant};
        result.matrix = read_foreign_matrix(contestant.text, who);
        return result;
      }
      case Contestant::Kind::kLfdFiles: {
        std::vector<retrieval::Signature> signatures;
        for (const std::string& model : who.classes.models)
          signatures.push_back(read_foreign_lfd(contestant.text, model));
        Result result{.contestant = contestant};
        compare_signatures(result, *retrieval::make_descriptor("lfd:ntu"), signatures);
        return result;
      }
      case Contestant::Kind::kDescriptor:
        break;
    }
    return own(contestant, features, who);
  }

  static Result by_collection(const Result& plain) {
    Result result{.contestant = plain.contestant, .bytes = plain.bytes};
    result.contestant.label += "@collection";
    result.distance = plain.distance.empty() ? "" : plain.distance + "; then by diffusion through all models";
    result.invariant = plain.invariant;
    result.describe_seconds = plain.describe_seconds;
    const Clock::time_point begin = Clock::now();
    result.matrix = search::collection_distances(plain.matrix);
    const double pairs = static_cast<double>(result.matrix.size()) * static_cast<double>(result.matrix.size());
    if (pairs > 0) result.compare_seconds = plain.compare_seconds + seconds_since(begin) / pairs;
    return result;
  }

  Result own(const Contestant& contestant, const retrieval::Features& features, const Participants& who) const {
    Result result{.contestant = contestant};
    const retrieval::DescriptorPointer descriptor = retrieval::make_descriptor(contestant.text);
    const std::size_t n = who.classes.models.size();
    std::vector<retrieval::Signature> signatures(n);
    for (const retrieval::Term& term : retrieval::parse_composite(contestant.text)) {
      const retrieval::FeatureTable& table = features.tables.at(term.spec);
      result.describe_seconds += table.seconds;
      for (std::size_t i = 0; i < n; ++i)
        signatures[i].insert(signatures[i].end(), table.signatures[i].begin(), table.signatures[i].end());
    }
    compare_signatures(result, *descriptor, signatures);
    return result;
  }

  const EvaluationPlan& plan_;
  const fs::path& out_;
  const EvaluationSettings& settings_;
  Classification whole_;
  Evaluation evaluation_;
  std::size_t total_ = 1;
};

}  // namespace

Evaluation run_evaluation(const EvaluationPlan& plan, const fs::path& out, const EvaluationSettings& settings,
                          report::PictureTroubles& troubles) {
  if (plan.contestants.empty()) throw ParameterError("there is nothing to evaluate: no descriptor and no matrix");
  const bool describes = std::ranges::any_of(
      plan.contestants, [](const Contestant& c) { return c.kind == Contestant::Kind::kDescriptor; });
  if (describes && !plan.folder) throw ParameterError("descriptors need a folder of meshes");
  Run run(plan, out, settings);
  fs::create_directories(out / "matrices");
  const FolderLock lock(out);
  Evaluation evaluation = run.go();
  if (evaluation.complete) troubles = write_report(out, evaluation, laboratory::provenance(settings.command_line));
  return evaluation;
}

}  // namespace rectilin::evaluation
