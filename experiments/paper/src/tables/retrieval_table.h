// The tables of the paper's section 7: rows of descriptors, scored on a collection, beside the paper's figures.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "rectilin/paper/experiment.h"
#include "rectilin/retrieval/collection.h"
#include "rectilin/retrieval/scores.h"
#include "rectilin/retrieval/significance.h"

namespace rectilin::paper::tables {

/// 1-NN, first tier, second tier and DCG in percent; NaN where the paper has a dash.
using PaperScores = std::array<double, 4>;
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Row {
  std::string label;
  std::string descriptor;  ///< for retrieval::make_descriptor(); empty: the paper cites it and so do we
  PaperScores paper;       ///< on the test half of the Princeton Shape Benchmark
};

/// What the tables are run on.
struct TableSettings {
  std::string folder;   ///< of meshes, and
  std::string classes;  ///< their .cla file; without both a small collection of built-in shapes is made
  std::string cache;    ///< folder in which signatures are kept; a temporary one if empty
  int models = 5;       ///< of each class of the built-in collection
  int size = 256;       ///< pixels in a row of a picture

  void bind(Parameters& parameters);
};

struct ScoredRow {
  Row row;
  retrieval::Scores scores;  ///< empty for cited rows
  retrieval::Interval dcg;   ///< 95 %
  std::size_t bytes = 0;
  double describe_seconds = 0, compare_seconds = 0;
};

struct ScoredTable {
  std::vector<ScoredRow> rows;
  std::vector<std::size_t> class_of;  ///< of each model
  std::vector<std::string> errors;
  std::string collection;  ///< in words
};

/// Descriptors of the rows may hold `$size`, which the settings replace. Throws Stopped.
ScoredTable score(const std::vector<Row>& rows, const TableSettings& settings, const ExperimentContext& context);

/// Ours beside the paper's, with a picture of the DCG.
ExperimentResult present(const std::string& name, const std::string& title, const ScoredTable& table);

}  // namespace rectilin::paper::tables
