// A hash that gives the same number on every machine, so that it can be stored and compared later.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace rectilin {

/// The 64-bit hash FNV-1a (Fowler, Noll and Vo 1991). Good against accidental collisions; an adversary can make them.
class Fnv1a {
 public:
  Fnv1a& add(std::string_view text) {
    for (const char c : text) step(static_cast<unsigned char>(c));
    return *this;
  }
  /// Takes all 64 bits of the number in one step, unlike the standard FNV-1a, which goes byte by byte.
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
