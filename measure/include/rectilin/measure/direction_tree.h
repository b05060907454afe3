// The same sums as FlatSum in about sqrt(N) operations a direction instead of N.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/flat_sum.h"

namespace rectilin {

struct DirectionTreeKernels;
struct DirectionTreeNodes;

/// A tree over the area vectors in their stored order, which is that of a space-filling curve of
/// directions.
///
/// A node stands for a run of consecutive vectors: their sum V and a cap around it that holds all
/// their directions. Where the great circle u . v = 0 misses the cap, all u . v_i have one sign and
/// the node contributes exactly |u . V| = sum |u . v_i|; only nodes that the circle meets are
/// opened. On a smooth mesh those are about sqrt(N) of N. (The idea is that of a bounding volume
/// hierarchy, with the great circle in the place of a ray.)
///
/// Any order of vectors gives right sums; a bad one gives no gain. Nor is there any where nearly
/// all vectors lie across u, as for a surface of revolution seen along its axis. A direction whose
/// circle meets more than an eighth of some level's nodes is left to the flat sum; how many it
/// meets is known before they are opened.
///
/// A result depends on its direction, the area vectors and the instruction set alone, bit for bit.
/// The requirements on directions are FlatSum's. Const and thread safe; large calls use TBB's
/// current arena.
class DirectionTree {
 public:
  /// `vectors` must outlive this object, unchanged; it keeps a copy, too, in an order of its own and
  /// shortened to 16 bytes each, for locality. O(N log N), in parallel. Uses the instruction set chosen at this moment
  /// (see ScopedInstructionSet).
  explicit DirectionTree(const AreaVectors& vectors);

  /// h[k] = sum_i |u[k] . v_i|, with an error of at most kErrorBound |u| S.
  ///
  /// With a positive `resolution` (radians, at most pi / 2) a node whose cap's radius is below it
  /// is never opened, and h[k] is a lower bound of the sum: |u . V| <= sum |u . v_i| always holds.
  /// (For a direction left to the flat sum it is the sum.)
  void values(std::span<const Vector3> u, std::span<double> h, double resolution = 0) const;

  /// g[k] = sum of sign(u[k] . V) V over the nodes at which values() stops. h(w) >= g . w for every
  /// w; at w = u[k], g . w equals the value that values() gives with the same resolution. Both up
  /// to kErrorBound |w| S.
  void cuts(std::span<const Vector3> u, std::span<Vector3> g, double resolution = 0) const;

  /// Rounding error of values() relative to |u| S, at worst, for any instruction set and up to 2^27
  /// vectors: sums in registers have a bounded number of terms and are combined with compensation.
  /// Most of it is for leaves, which hold a vector in 40 bits a component: all errors would have to
  /// fall the same way in leaves that weigh as much as the mesh. Where many vectors share the weight
  /// they average out: errors are below 1e-13, and 1e-14 on smooth meshes.
  static constexpr double kErrorBound = 8e-12;

  /// Whether this tree is faster than FlatSum on a typical mesh, and never much slower: what it
  /// costs to find that a direction is for the flat sum weighs little from so many vectors on.
  static bool worthwhile(std::size_t vectors);

  std::size_t size() const { return flat_.size(); }
  std::size_t bytes() const;  ///< about 20 bytes a vector, its copies of the vectors included

 private:
  template <class Result, class Walk, class Flat>
  void evaluate(std::span<const Vector3> u, std::span<Result> results, double resolution, const Walk& walk,
                const Flat& flat) const;

  FlatSum flat_;
  std::size_t bytes_ = 0;                 // size of storage_
  std::shared_ptr<std::byte[]> storage_;  // never written after construction, hence shared by copies
  std::shared_ptr<const DirectionTreeNodes> nodes_;
  const DirectionTreeKernels* kernels_;
  Vector3 total_ = Vector3::Zero();  // sum of the v_i, signed as in the leaves
};

}  // namespace rectilin
