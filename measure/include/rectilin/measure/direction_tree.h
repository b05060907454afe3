// A tree over directions that computes the same sums as FlatSum in about sqrt(N) operations for each direction instead
// of N.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/flat_sum.h"

namespace rectilin {

struct DirectionTreeKernels;
struct DirectionTreeNodes;
class LazyTwigs;

/// A tree over the area vectors, in their stored order, which follows a space-filling curve of directions, and within
/// runs of 32,768 in an order of its own.
///
/// A node stands for a run of consecutive vectors: it has their sum V and a cap, a small disc on the sphere that
/// holds all their directions. If the great circle u . v = 0 misses the cap, all u . v_i have the same sign, and the
/// node contributes exactly |u . V| = sum |u . v_i|. Only nodes whose caps the circle meets are opened; on a smooth
/// mesh those are about sqrt(N) of N. (The idea is that of a bounding volume hierarchy, with the great circle in
/// place of a ray.)
///
/// The sums are right for any order of the vectors, but a bad order makes them slow. So do meshes on which nearly all
/// vectors are orthogonal to u, such as a surface of revolution seen along its axis. A direction whose circle meets
/// more than an eighth of the nodes of some level is therefore left to the flat sum; that is noticed before those nodes
/// are opened.
///
/// A result depends on its direction, the area vectors and the instruction set alone, bit for bit. Directions must
/// satisfy what FlatSum requires. Const and thread safe; large calls use TBB's current arena.
class DirectionTree {
 public:
  /// `vectors` must outlive this object, unchanged. The tree also keeps a copy of them, in its own order and shortened
  /// to 16 bytes each, so that neighbours are close in memory. O(N log N), in parallel. Uses the instruction set that
  /// is in force when it is made (see ScopedInstructionSet).
  explicit DirectionTree(const AreaVectors& vectors) : DirectionTree(vectors, TwigRule()) {}

  /// A very fine mesh also gets twigs when values() is first asked for: vectors once more in 8 bytes, for values alone
  /// and only near the great circle, where little depends on their lengths. A direction of ten million vectors
  /// then takes half the time; making them takes a third of the time for a tree, or a little more.
  struct TwigRule {
    /// Number of vectors from which on a tree gets twigs. If circles meet much of it in the mean, for the error would
    /// be too large, it gets none nevertheless.
    std::size_t fewest = 3'000'000;
    double error = 1.9e-10;  ///< what they may add to the error of a value, relative to |u| S; else they are not read
  };
  DirectionTree(const AreaVectors& vectors, const TwigRule& twigs);

  /// h[k] = sum_i |u[k] . v_i|, with an error of at most kErrorBound |u| S, or with twigs TwigRule::error |u| S more.
  ///
  /// With a positive `resolution` (radians, at most pi / 2), where twigs play no part, a node whose cap has a smaller
  /// radius is never opened, and h[k] is a lower bound of the sum, since |u . V| <= sum |u . v_i|. (For a direction
  /// that is left to the flat sum it is the sum itself.)
  void values(std::span<const Vector3> u, std::span<double> h, double resolution = 0) const;

  /// g[k] = the sum of sign(u[k] . V) V over the nodes at which values() stops. Then h(w) >= g . w for every w, and at
  /// w = u[k] g . w equals the value that values() gives for the same resolution, both up to kErrorBound |w| S. Twigs
  /// play no part.
  void cuts(std::span<const Vector3> u, std::span<Vector3> g, double resolution = 0) const;

  /// The largest possible rounding error without twigs, relative to |u| S, for any instruction set and up to 2^27
  /// vectors: sums in registers have a bounded number of terms and are combined with compensation. Most of the bound is
  /// for leaves, which hold a vector in 40 bits a component; to reach it, all errors would have to fall the same way in
  /// leaves that weigh as much as the mesh. Where many vectors share the weight errors average out: they are below
  /// 1e-13, and 1e-14 on smooth meshes.
  static constexpr double kErrorBound = 8e-12;

  /// Is this tree faster than FlatSum on a typical mesh and never much slower? From so many vectors on it costs little
  /// to find out that a direction must be left to the flat sum.
  static bool worthwhile(std::size_t vectors);

  std::size_t size() const { return flat_.size(); }
  /// Memory used by now, including the copies of the vectors: about 20 bytes a vector, 30 with twigs.
  std::size_t bytes() const;

 private:
  template <class Result, class Walk, class Flat>
  void evaluate(std::span<const Vector3> u, std::span<Result> results, double resolution, const Walk& walk,
                const Flat& flat) const;

  FlatSum flat_;
  std::size_t bytes_ = 0;                 // size of storage_
  std::shared_ptr<std::byte[]> storage_;  // not written after construction, so copies share it
  std::shared_ptr<const DirectionTreeNodes> nodes_;
  std::shared_ptr<LazyTwigs> twigs_;
  const DirectionTreeKernels* kernels_;
  Vector3 total_ = Vector3::Zero();  // sum of the v_i, signed as in the leaves
};

}  // namespace rectilin
