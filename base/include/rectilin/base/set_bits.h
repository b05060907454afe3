// A table of the bits of a byte, for loops in vector registers that keep some lanes.
#pragma once

#include <array>
#include <cstdint>

namespace rectilin {

/// kSetBits[byte]: the places of its set bits, ascending, then zeros.
inline constexpr auto kSetBits = [] {
  std::array<std::array<std::uint8_t, 8>, 256> result = {};
  for (unsigned byte = 0; byte < 256; ++byte)
    for (unsigned bit = 0, count = 0; bit < 8; ++bit)
      if ((byte >> bit & 1) != 0) result[byte][count++] = static_cast<std::uint8_t>(bit);
  return result;
}();

}  // namespace rectilin
