// The interface between the driver of the sum by runs (run_sum.cpp) and its vector loops (run_kernels.cpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "sums/flat_sum_kernels.h"

namespace rectilin {

/// Number of vectors in a run: eight doubles fill one AVX-512 register, or a few narrower ones.
inline constexpr std::size_t kRunLength = 8;

/// A block of runs stays in the first-level cache while all directions read it, and bounds the number of terms in a
/// register.
inline constexpr std::size_t kRunsPerBlock = 128;

/// The number of runs is a multiple of this: two of the widest registers.
inline constexpr std::size_t kRunsTogether = 16;

/// Runs of vectors: the vectors of run r are `vectors` 8 r to 8 r + 7. `sums` holds their sums V, and radius[r]
/// is |V| sin(r), r the radius of a cap around V with all of them; infinite if it reaches a right angle.
/// Padded with zeros to a multiple of kRunsTogether.
struct Runs {
  VectorSpan<double> vectors, sums;
  const double* radius;
};

struct RunQuery {
  Slope<double> slope;
  double reach;  ///< |u| / |scale|: the circle meets a cap of radius r if |s| < |V| sin(r) reach
};

/// Adds the sum of the v with s < 0 to sums[3 k], sums[3 k + 1], sums[3 k + 2] for every direction k.
void sum_negative(const Runs& runs, const RunQuery* queries, std::size_t directions, double* sums);

/// Fills the sums and radii of runs.
void fill_runs(const VectorSpan<double>& vectors, double* x, double* y, double* z, double* radius);

}  // namespace rectilin
