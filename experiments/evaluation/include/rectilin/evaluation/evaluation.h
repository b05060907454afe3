// Runs descriptors over a collection with classes and scores how well they find them.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "rectilin/report/plot.h"
#include "rectilin/retrieval/collection.h"
#include "rectilin/retrieval/descriptor.h"
#include "rectilin/retrieval/scores.h"
#include "rectilin/retrieval/significance.h"

namespace rectilin::evaluation {

/// A row of the tables: a descriptor, or what somebody else's program made.
struct Contestant {
  enum class Kind {
    kDescriptor,
    kMatrix,    ///< distances
    kLfdFiles,  ///< signatures of the light field descriptor, see retrieval::read_lfd_files()
  };
  std::string label;  ///< unique
  std::string text;   ///< for retrieval::make_descriptor(), the matrix's file, or the folder of the signatures
  Kind kind = Kind::kDescriptor;
};

/// Reads descriptors separated by commas or blanks, each `[LABEL=]DESCRIPTOR`, or `[LABEL=]@FILE` for a file with
/// tuned weights (see weights.h). A comma before a number belongs to a value. Throws ParameterError for what cannot be
/// made and for labels that are there twice.
std::vector<Contestant> parse_contestants(const std::vector<std::string>& lists);

/// Adds matrices or folders of signatures, each `[LABEL=]FILE`; the file's name without its extension is the label if
/// there is none.
void add_foreign(std::vector<Contestant>& contestants, const std::vector<std::string>& files, Contestant::Kind kind);

struct EvaluationPlan {
  std::optional<std::filesystem::path> folder;  ///< of meshes; may be left out if no contestant is a descriptor
  std::filesystem::path classes;                ///< the .cla file
  std::vector<Contestant> contestants;
  /// Each contestant a second time, ranked by diffusion through all models, without their classes: LABEL@collection,
  /// see search::collection_distances().
  bool by_collection = false;
};

struct EvaluationSettings {
  std::stop_token stop = {};
  std::string command_line = {};  ///< for the record
  /// Called from any thread, one at a time: items done of all, seconds left (infinite while unknown), what goes on.
  std::function<void(std::size_t done, std::size_t total, double seconds_left, const std::string& text)> on_progress =
      {};
};

/// What a contestant came to.
struct Result {
  Contestant contestant;
  std::size_t bytes = 0;                             ///< of a signature; 0 for matrices
  std::string distance = {}, invariant = {};         ///< in words; empty for matrices
  double describe_seconds = 0, compare_seconds = 0;  ///< one model, one pair; on one thread
  retrieval::DistanceMatrix matrix = {};
  retrieval::Scores scores = {};
  std::vector<retrieval::Interval> intervals = {};  ///< 95 %, of named_measures(), micro
};

/// Two contestants compared on one measure, over the queries that count.
struct Comparison {
  std::size_t first, second;
  retrieval::PairedDifference difference;  ///< of the DCG, first less second
  double corrected = 1;                    ///< p corrected for all pairs (Holm 1979)
};

struct Evaluation {
  bool complete = false;                   ///< false: stopped, and only what was computed until then is kept
  retrieval::Classification classes;       ///< of the models evaluated: the matrices' rows
  std::vector<std::string> missing;        ///< models of the .cla without a file
  std::vector<std::string> failed;         ///< models whose mesh failed
  std::vector<std::string> errors;         ///< a line for each of those
  std::vector<std::string> losses;         ///< a line for each mesh that is not all that its file holds
  std::vector<std::string> empty_classes;  ///< among the models evaluated
  std::vector<std::string> small_classes;  ///< of one or two models: they are in no mean
  std::vector<Result> results;             ///< in the contestants' order
  std::vector<Comparison> comparisons;     ///< all pairs
};

/// Evaluates and writes, into `out`, which is made if need be:
///     features/            signatures, see retrieval::compute_features()
///     matrices/LABEL.matrix, LABEL.models   distances, and the models of their rows ('/' in a label becomes '_')
///     summary.json, scores.csv, classes.csv, queries.csv, tests.csv, plots/, index.html
/// A model without a file, or whose mesh fails, is in no matrix and is named. A matrix of others may be of all models
/// of the classification or of those that are left. Returns lines about pictures that could not be drawn in `troubles`.
/// Throws ParameterError or std::runtime_error for a plan that cannot be carried out.
Evaluation run_evaluation(const EvaluationPlan& plan, const std::filesystem::path& out,
                          const EvaluationSettings& settings, report::PictureTroubles& troubles);

}  // namespace rectilin::evaluation
