// The objective's inner loop h(u) = sum_i |u . v_i| for meshes of middling size, by runs of vectors with similar
// directions.
#pragma once

#include <cstddef>
#include <span>

#include "rectilin/measure/area_vectors.h"

namespace rectilin {

struct Runs;
struct RunQuery;

/// Sums over the area vectors in their stored order, in runs of sixteen. A run has a sum V and a cap, a small disc on
/// the sphere around V that holds the directions of its vectors. Where the great circle u . v = 0 misses the cap, V
/// stands for the run; only the vectors of other runs are looked at one by one. The same goes for groups of eight runs.
/// A direction tree does this on many levels; two are made in a fraction of the time.
///
/// A result depends on its direction, the area vectors and the instruction set alone, bit for bit. Directions must
/// satisfy what FlatSum requires. Const and thread safe; large calls use TBB's current arena.
class RunSum {
 public:
  /// `vectors` must outlive this object, unchanged, and are on one hemisphere as area_vectors() leaves them, or the
  /// runs at its rim gain nothing. O(N).
  explicit RunSum(const AreaVectors& vectors);

  /// As FlatSum::values(), with an error of at most kErrorBound |u| S.
  void values(std::span<const Vector3> u, std::span<double> h) const;

  /// As FlatSum::cuts(): h(w) >= g[k] . w for every w, with equality at u[k], both up to kErrorBound |w| S.
  void cuts(std::span<const Vector3> u, std::span<Vector3> g) const;

  /// For any instruction set and up to 2^17 vectors: a register takes at most 1160 terms of a block of groups, and
  /// then those of the other blocks.
  static constexpr double kErrorBound = 5e-13;

  /// For some hundreds of directions, are the runs better than both FlatSum and a tree that has to be made first?
  static bool worthwhile(std::size_t vectors);

 private:
  using RunKernel = void (*)(const Runs&, const RunQuery*, std::size_t, double*);
  template <class Result, class Finish>
  void evaluate(RunKernel kernel, std::size_t width, std::span<const Vector3> u, std::span<Result> results,
                const Finish& finish) const;

  const AreaVectors* vectors_;
  AlignedDoubles runs_, groups_;  // x, y, z of sums and the caps' radii, each padded with zeros
  AlignedDoubles rest_;           // x, y, z of the vectors that do not fill a run
  Vector3 total_ = Vector3::Zero();
};

}  // namespace rectilin
