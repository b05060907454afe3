// The interface between the driver of the sum by runs (run_sum.cpp) and its vector loops (run_kernels.cpp).
#pragma once

#include <cstddef>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// Number of vectors in a run. Of 8, 16 and 32, 16 made proofs of meshes fastest (papers/throughput.md).
inline constexpr std::size_t kRunLength = 16;

/// Number of runs in a group.
inline constexpr std::size_t kGroup = 8;

/// A block of groups stays in the first-level cache while all directions read it, and bounds the number of terms in a
/// register. The number of groups is a multiple of this, which is two of the widest registers.
inline constexpr std::size_t kGroupsPerBlock = 16;

/// Sums V of consecutive vectors, and of the caps around V with all of them the radii (cap.h).
struct Caps {
  VectorSpan<double> sums;
  const double* radius;
};

/// Runs of vectors, and groups of runs: the vectors of run r are `vectors` kRunLength r and following, the runs of
/// group g are `runs` kGroup g and following. Runs and groups that are missing are zeros. `rest` are kRunLength more
/// vectors, each looked at for itself.
struct Runs {
  VectorSpan<double> vectors;
  Caps runs, groups;
  VectorSpan<double> rest;
};

struct RunQuery {
  Slope<double> slope;
  double reach;  ///< |u| / |scale|: the circle meets a cap of radius r if |s| < |V| sin(r) reach
};

/// Adds the sum of min(s, 0) to sums[k] for every direction k, or the sum of the v with s < 0 to sums[3 k], sums[3 k +
/// 1], sums[3 k + 2].
void sum_negative_parts(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums);
void sum_negative_vectors(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums);

/// Finds the sums and the caps of `length` vectors each, the last of fewer: both are multiples of kRunLength.
void find_caps(const VectorSpan<double>& vectors, std::size_t length, double* x, double* y, double* z, double* radius);

}  // namespace rectilin
