// The tables of the paper's section 7: descriptors scored on a collection, beside the paper's numbers.
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
  std::string descriptor;  ///< for retrieval::make_descriptor(); empty for a row that is only cited, as in the paper
  PaperScores paper;       ///< scores on the test half of the Princeton Shape Benchmark
};

/// What the tables are run on.
struct TableSettings {
  std::string folder;   ///< folder of meshes; needs `classes`
  std::string classes;  ///< their .cla file; without both a small built-in collection is used
  std::string cache;    ///< folder in which signatures are kept; a temporary one if empty
  int models = 5;       ///< of each class of the built-in collection
  int size = 256;       ///< width and height of a picture in pixels

  void bind(Parameters& parameters);
};

struct ScoredRow {
  Row row;
  retrieval::Scores scores;                        ///< empty for cited rows
  std::array<retrieval::Interval, 4> intervals{};  ///< 95 %, from a bootstrap over classes; of what PaperScores has
  std::size_t bytes = 0;
  double describe_seconds = 0, compare_seconds = 0;
};

struct ScoredTable {
  std::vector<ScoredRow> rows;
  std::vector<std::size_t> class_of;  ///< class of each model
  std::vector<std::string> errors;
  std::string collection;  ///< the collection in words
};

/// Scores the rows on the collection. Descriptors of rows may contain `$size`, which becomes TableSettings::size.
/// Throws Stopped.
ScoredTable score(const std::vector<Row>& rows, const TableSettings& settings, const ExperimentContext& context);

/// Our scores and their intervals beside the paper's, with a plot of the DCG.
ExperimentResult present(const std::string& name, const std::string& title, const ScoredTable& table);

}  // namespace rectilin::paper::tables
