// Twigs: the lowest two levels of a direction tree once more, in half the bytes, for values alone.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

#include "tree/direction_tree_kernels.h"

namespace rectilin {

/// The kFan leaves under a node of level 1: their sums and caps in two cache lines, where a family of level 0 takes
/// three, and the vectors of each leaf in one, where a leaf takes two.
///
/// A vector w below a node with the sum V is given as share (V + p e + q f), where e and f are the axes along which V
/// is not longest. Rounding a share moves the vector along itself, and u . w is small where the circle of u meets the
/// node; p and q are no longer than the node is wide. So either error shrinks with the node: from some millions of
/// vectors on 21 bits are enough.
///
/// That holds for nodes whose radius r satisfies kNarrow |V| sin(r) <= the longest component of V. Others have an empty
/// twig. Proof: let a and b be unit vectors in the cap whose components along the longest axis of V are A and B.
/// |a / A - b / B| = |axis x (a x b)| / (A B) <= sin(a, b) / (A B), and A >= cos(54.8 + 4.2 degrees) > 1/2. So a vector
/// w in the cap of a leaf with the sum b |b| and radius s has (p, q) of length at most |b| sin(s) / A < 2 |b| sin(s).
///
/// Errors, if the circle meets a leaf of |V| sin(radius) = R: that of (p, q) is at most sqrt(2) 2^-20 R; that of a
/// share 2^-23, for each of eight vectors and times |u . (V + p e + q f)|, which is at most 2.5 R as the vector is
/// within two radii of the circle. Together less than 4 2^-20 R |u|, so of h less than 2^-17 R |u| for each leaf that
/// is met. In the same way the sums of the leaves of a node add at most 2^-26 R |u| with the node's R (twice their
/// shares' part: what is missing in a sum cannot be shared out). Ends of ranges: a share of one is short of it by one
/// unit, and then the only one.
struct alignas(64) Twig {
  std::int32_t shares[kFan];               ///< of the sums of leaves, times kNodeShare
  std::int32_t first[kFan], second[kFan];  ///< p and q times kNodeStep |V| sin(r) of the node
  float radii[kFan];                       ///< |V| sin(r) of the leaf over that of the node, rounded up
  /// For each vector, from the lowest bit: p and q in kStepBits each, from kMiddle on, times kVectorStep |V| sin(r) of
  /// the leaf; the share times kVectorShare. Missing leaves and vectors have a share of zero.
  std::uint64_t vectors[kFan][kLeaf];
};
static_assert(sizeof(Twig) == 640);
inline constexpr std::size_t kTwigLines = sizeof(Twig) / 64, kFirstLeafLine = 2;

inline constexpr double kNarrow = 8;
inline constexpr double kNodeShare = 0x1p-31, kNodeStep = 0x1p-30;
inline constexpr double kVectorShare = 0x1p-22, kVectorStep = 0x1p-19;
inline constexpr int kStepBits = 21, kShareBits = 22;
inline constexpr double kMiddle = 0x1p20;

/// The error of h, relative to |u|, over the sum of R over the leaves that are met, and the sum of R over their
/// nodes, where it is kNodeError times that.
inline constexpr double kTwigError = 0x1p-17, kNodeError = 0x1p-9;

/// The twigs of a tree, made when they are first asked for. Thread safe.
class LazyTwigs {
 public:
  /// For a tree with so many leaves and at least two levels; there are none if it is zero.
  explicit LazyTwigs(std::size_t leaf_count) : leaf_count_(leaf_count) {}

  /// Null if most queries of random directions could not use them. `nodes` are the same at every call.
  const Twig* get(const DirectionTreeNodes& nodes);

  std::size_t bytes() const { return bytes_; }  ///< memory used by now

 private:
  void make(const DirectionTreeNodes& nodes);

  std::size_t leaf_count_;
  std::once_flag once_;
  std::shared_ptr<std::byte[]> storage_;
  std::atomic<std::size_t> bytes_ = 0;
};

}  // namespace rectilin
