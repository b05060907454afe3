// What a comparison says, in numbers.
#pragma once

#include <vector>

#include "rectilin/laboratory/results.h"
#include "rectilin/laboratory/statistics.h"

namespace rectilin::laboratory {

/// Gaps that runs are asked to reach: 10^-0.5, 10^-1, ... 10^-9.
const std::vector<double>& targets();

/// "1e-3", or "10^-2.5" between powers of ten.
std::string target_name(double target);

/// An entry on a mesh.
struct Cell {
  std::size_t runs = 0, failures = 0;
  double low = 0, median = 0, high = 0;  ///< 10 %, 50 %, 90 % quantiles of the final gap; NaN without runs
  std::vector<RunningTime> to_target;    ///< in evaluations, one a target
};

/// How an entry stands after some evaluations, over all meshes.
struct Standing {
  double mean_rank = 0;  ///< mean over meshes of the rank of its median gap; 1: always the least
  double gap = 0;        ///< geometric mean over meshes of the median gap
  std::size_t wins = 0;  ///< meshes on which no other has a smaller median gap
};

/// A rank-sum test of final gaps on one mesh.
struct PairTest {
  std::size_t mesh, first, second;  ///< entries, first < second
  RankSum test;
  double corrected = 1;  ///< p after Holm's correction over all tests of the comparison
};

/// What an entry used, over all its runs.
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

  /// Entries by their standing at the budget of that index, the best first.
  std::vector<std::size_t> order(std::size_t budget) const;
};

inline constexpr double kSignificance = 0.05;

/// Is a target wider than the mesh's certificate? Only then can it be told whether a run has reached it.
bool decidable(const MeshResult& mesh, double target);

/// Quantile of gaps, interpolated between their logarithms.
double gap_quantile(const std::vector<double>& gaps, double p);

Summary summarise(const Results& results);

/// All numbers; those that do not exist (an expected running time without a success) are null.
Json to_json(const Summary& summary, const Results& results);

}  // namespace rectilin::laboratory
