// A hash that gives the same number on every machine, so that it can be stored and compared later.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// The same idea over words of eight bytes, several times as quick for long data; an end that is shorter is filled with
/// zeros. Words are in the byte order of the machine.
class Fnv1aWords {
 public:
  Fnv1aWords& add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x100000001b3u;
    hash_ ^= hash_ >> 29;  // so that high bits count in low ones
    return *this;
  }
  Fnv1aWords& add(const void* data, std::size_t size) {
    const char* bytes = static_cast<const char*>(data);
    for (; size > 0; bytes += 8) {
      const std::size_t count = size < 8 ? size : 8;
      std::uint64_t word = 0;
      std::memcpy(&word, bytes, count);
      add(word);
      size -= count;
    }
    return *this;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace rectilin
