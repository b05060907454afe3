// The interface between the driver of the flat sum (flat_sum.cpp) and its vector loops (flat_sum_kernels.cpp).
#pragma once

#include <cstddef>

#include "sums/slope.h"

namespace rectilin {

/// Area vectors as a structure of arrays that somebody else owns.
template <class T>
struct VectorSpan {
  const T *x, *y, *z;
  std::size_t size;

  VectorSpan slice(std::size_t begin, std::size_t end) const { return {x + begin, y + begin, z + begin, end - begin}; }
};

/// Sizes are multiples of this many vectors: one cache line, which is the widest register of any instruction set.
template <class T>
inline constexpr std::size_t kLane = 64 / sizeof(T);

/// Number of vectors summed in registers at a time. Three arrays of this length take 24 KB, so that they stay in the
/// first-level cache while all directions read them again and again.
template <class T>
inline constexpr std::size_t kBlock = 8192 / sizeof(T);

/// Largest number of vectors in one kernel call; also the share of a task when threads share the vectors.
inline constexpr std::size_t kChunk = 32768;

/// Largest number of directions in one kernel call; their slopes and sums are on the stack. A population of fifty
/// rotations fits.
inline constexpr std::size_t kSlab = 192;

/// For every direction k: adds kOutputs sums over `faces` and `tail` to sums[kOutputs k], ... `tail` is either empty or
/// the padded end of the vectors. Sums are in units of the slope's scale.
template <class T>
using FlatKernel = void (*)(const VectorSpan<T>& faces, const VectorSpan<T>& tail, const Slope<T>* slopes,
                            std::size_t directions, double* sums);

/// The three kinds of sums, where s is a x + b y + z (slope.h says how they are used).
enum FlatQuantity : int {
  kNegativePart,  ///< min(s, 0): one output
  kNegativeSum,   ///< v where s < 0: three outputs
  kTotal,         ///< v: three outputs
};

constexpr std::size_t outputs(FlatQuantity quantity) { return quantity == kNegativePart ? 1 : 3; }

/// The kernels of one instruction set, indexed by FlatQuantity.
struct FlatKernels {
  FlatKernel<float> f32[3];
  FlatKernel<double> f64[3];

  template <class T>
  FlatKernel<T> get(FlatQuantity quantity) const {
    if constexpr (sizeof(T) == sizeof(float)) {
      return f32[quantity];
    } else {
      return f64[quantity];
    }
  }
};

/// The kernels of the best instruction set of the processor that ScopedInstructionSet allows.
const FlatKernels& flat_kernels();

}  // namespace rectilin
