// A hash that is the same on every machine.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace rectilin {

/// FNV-1a with 64 bits (Fowler, Noll and Vo 1991): tells equal sequences from others, but not against an adversary.
class Fnv1a {
 public:
  Fnv1a& add(std::string_view text) {
    for (const char c : text) step(static_cast<unsigned char>(c));
    return *this;
  }
  /// All bits in one step.
  Fnv1a& add(double number) {
    step(std::bit_cast<std::uint64_t>(number));
    return *this;
  }
  std::uint64_t value() const { return hash_; }

 private:
  void step(std::uint64_t bits) { hash_ = (hash_ ^ bits) * 0x100000001b3u; }

  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace rectilin
