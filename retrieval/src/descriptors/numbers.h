// Signatures that are lists of single-precision numbers.
#pragma once

#include <cstring>
#include <span>

#include "rectilin/retrieval/descriptor.h"

namespace rectilin::retrieval {

inline Signature signature_of(std::span<const float> numbers) {
  Signature bytes(numbers.size_bytes());
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

inline float number_at(SignatureView signature, std::size_t i) {
  float x;
  std::memcpy(&x, signature.data() + 4 * i, 4);
  return x;
}

/// Sum of absolute differences of numbers [begin_a, begin_a + count) and [begin_b, ...), in their order.
inline double l1(SignatureView a, SignatureView b, std::size_t begin_a, std::size_t begin_b, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i)
    sum += std::abs(static_cast<double>(number_at(a, begin_a + i)) - number_at(b, begin_b + i));
  return sum;
}

/// Divides by the sum of absolute values; leaves zeros as they are.
inline void to_unit_l1(std::span<float> numbers) {
  double sum = 0;
  for (const float x : numbers) sum += std::abs(x);
  if (sum > 0)
    for (float& x : numbers) x = static_cast<float>(x / sum);
}

}  // namespace rectilin::retrieval
