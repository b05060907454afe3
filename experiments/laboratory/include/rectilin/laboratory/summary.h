// The results of a comparison in numbers.
#pragma once

#include <vector>

#include "rectilin/laboratory/results.h"
#include "rectilin/laboratory/statistics.h"

namespace rectilin::laboratory {

/// The gaps that runs are asked to reach: 10^-0.5, 10^-1, ... 10^-9.
const std::vector<double>& targets();

/// "1e-3", or "10^-2.5" between powers of ten.
std::string target_name(double target);

/// One cell of the table of entries by meshes: how the runs of an entry on a mesh ended.
struct Cell {
  std::size_t runs = 0, failures = 0;
  double low = 0, median = 0, high = 0;  ///< 10 %, 50 %, 90 % quantiles of the final gap; NaN without runs
  std::vector<RunningTime> to_target;    ///< in evaluations, one element for each target
};

/// How an entry ranks after some number of evaluations, over all meshes.
struct Standing {
  double mean_rank = 0;  ///< rank of its median gap, mean over meshes; 1: always the best
  double gap = 0;        ///< its median gap, geometric mean over meshes
  std::size_t wins = 0;  ///< meshes on which no other has a smaller median gap
};

/// A rank-sum test of the final gaps of two entries on one mesh.
struct PairTest {
  std::size_t mesh, first, second;  ///< entries, first < second
  RankSum test;
  double corrected = 1;  ///< p after Holm's correction over all tests of the comparison
};

/// What the runs of an entry used, on average.
struct Usage {
  double evaluations = 0, seconds = 0, cpu_seconds = 0;  ///< means per run
  double values = 0, cuts = 0, smooths = 0, turns = 0;   ///< means per run
};

struct Summary {
  std::vector<std::vector<Cell>> cells;           ///< [entry][mesh]
  std::vector<std::vector<RunningTime>> overall;  ///< [entry][target], all meshes
  std::vector<std::uint64_t> budgets;             ///< 100, 1,000, ... and the whole budget
  std::vector<std::vector<Standing>> standings;   ///< [budget][entry]
  std::vector<PairTest> tests;                    ///< by mesh and pair
  std::vector<Usage> usage;                       ///< [entry]

  /// The entries sorted by their standing at the budget with this index, the best first.
  std::vector<std::size_t> order(std::size_t budget) const;
};

inline constexpr double kSignificance = 0.05;

/// Is the target wider than the mesh's bounds? Only then can it be told whether a run has reached it.
bool decidable(const MeshResult& mesh, double target);

/// A quantile of gaps, interpolated between their logarithms.
double gap_quantile(const std::vector<double>& gaps, double p);

Summary summarise(const Results& results);

/// The summary as JSON; numbers that do not exist, such as the expected running time without a success, are null.
Json to_json(const Summary& summary, const Results& results);

}  // namespace rectilin::laboratory
