// What the driver of the flat sum (flat_sum.cpp) asks of its vector loops (flat_sum_kernels.cpp).
#pragma once

#include <cstddef>

#include "sums/slope.h"

namespace rectilin {

/// Vectors as a structure of arrays, not owned.
template <class T>
struct FaceSpan {
  const T *x, *y, *z;
  std::size_t size;

  FaceSpan slice(std::size_t begin, std::size_t end) const { return {x + begin, y + begin, z + begin, end - begin}; }
};

/// Sizes are multiples of this many vectors: one cache line, the widest register of any instruction
/// set.
template <class T>
inline constexpr std::size_t kLane = 64 / sizeof(T);

/// Vectors whose sum is formed in vector registers. Three arrays of this length take 24 KB: all
/// directions read them again and again from the first-level cache.
template <class T>
inline constexpr std::size_t kBlock = 8192 / sizeof(T);

/// Vectors that one kernel call sums at most; also a task's share when faces are split over
/// threads.
inline constexpr std::size_t kChunk = 32768;

/// Directions of one kernel call at most; their slopes and sums live on the stack. A population of
/// fifty rotations fits.
inline constexpr std::size_t kSlab = 192;

/// For every direction k, adds kOutputs sums over `faces` and `tail` to sums[kOutputs k], ...
/// `tail` is either empty or the padded end of the faces. Sums are in units of the slope's scale.
template <class T>
using FlatKernel = void (*)(const FaceSpan<T>& faces, const FaceSpan<T>& tail, const Slope<T>* slopes,
                            std::size_t directions, double* sums);

/// The three sums there are; s is a x + b y + z (see flat_slope.h for their use).
enum FlatQuantity : int {
  kNegativePart,  ///< min(s, 0): one output
  kNegativeSum,   ///< v where s < 0: three outputs
  kTotal,         ///< v: three outputs
};

constexpr std::size_t outputs(FlatQuantity quantity) { return quantity == kNegativePart ? 1 : 3; }

/// One instruction set's kernels, indexed by FlatQuantity.
struct FlatKernels {
  FlatKernel<float> single[3];
  FlatKernel<double> twofold[3];

  template <class T>
  FlatKernel<T> get(FlatQuantity quantity) const {
    if constexpr (sizeof(T) == sizeof(float)) {
      return single[quantity];
    } else {
      return twofold[quantity];
    }
  }
};

/// Kernels of the best instruction set that is present and not ruled out by ScopedInstructionSet.
const FlatKernels& flat_kernels();

}  // namespace rectilin
