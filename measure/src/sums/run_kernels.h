// The interface between the driver of the sum by runs (run_sum.cpp) and its vector loops (run_kernels.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// Number of vectors in a run. Of 8, 16 and 32, 16 made proofs of meshes fastest (papers/throughput.md).
inline constexpr std::size_t kRunLength = 16;

/// A block of runs stays in the first-level cache while all directions read it, and bounds the number of terms in a
/// register.
inline constexpr std::size_t kRunsPerBlock = 128;

/// The number of runs is a multiple of this: two of the widest registers.
inline constexpr std::size_t kRunsTogether = 16;

/// Runs of vectors: the vectors of run r are `vectors` kRunLength r and following. `sums` holds their sums V, and
/// radius[r] is that of the cap around V with all of them (cap.h). Padded with zeros to a multiple of kRunsTogether.
/// `rest` are kRunLength more vectors, each looked at for itself.
struct Runs {
  VectorSpan<double> vectors, sums;
  const double* radius;
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

/// Fills the sums and radii of runs.
void fill_runs(const VectorSpan<double>& vectors, double* x, double* y, double* z, double* radius);

}  // namespace rectilin
