// Sums of absolute differences of lists of bytes, as fast as the processor can.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rectilin::retrieval {

/// Views are kept in rows of a multiple of 16 bytes, so that no row ends inside a vector.
inline constexpr std::size_t kRow = 48;

/// The least over the permutations p of sum_k |a(k) - b(p(k))|, eq. (33), a and b of `views` rows of kRow bytes. Every
/// permutation has `views` entries, one after the other in `permutations`. Exact whatever the instruction set.
std::uint32_t least_distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t views,
                             std::span<const std::uint16_t> permutations);

/// All distances between rows of a and rows of b, of `row` bytes each (a multiple of 16): out[i * count_b + j] =
/// |a(i) - b(j)|.
void row_distances(const std::uint8_t* a, std::size_t count_a, const std::uint8_t* b, std::size_t count_b,
                   std::size_t row, std::uint32_t* out);

}  // namespace rectilin::retrieval
