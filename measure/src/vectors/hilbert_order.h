// Sorts area vectors so that neighbours have similar directions.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// One vector in order: the cell of its direction in the high half, its index in the low one.
using OrderedVector = std::uint64_t;
inline std::uint64_t cell(OrderedVector v) { return v >> 32; }
inline std::uint32_t index(OrderedVector v) { return static_cast<std::uint32_t>(v); }

struct DirectionOrder {
  std::unique_ptr<OrderedVector[]> memory;
  std::span<const OrderedVector> vectors;
  bool safe;  ///< are the vectors neither so long nor so short that products of squares might overflow or lose digits?
};

/// Writes the vectors from the first number up to the second. Called for short blocks, on any thread.
using MakeVectors = std::function<void(std::size_t, std::size_t)>;

/// Turns each vector to the same side of a fixed plane (v and -v are the same to the measure), and returns the nonzero
/// ones along a Hilbert curve over that hemisphere, which has 2^32 cells; those of one cell by index. O(N). The result
/// is the same for any number of threads and any instruction set. Vectors that do not exist yet are made a block at a
/// time, by `make`, and used while they are in the nearest cache.
DirectionOrder order_by_direction(std::vector<Vector3>& vectors, const MakeVectors& make = {});

}  // namespace rectilin
