// Numbers out of and into binary data of either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// Walks over binary data; errors name the byte. Refers to the data and the name without copying
/// them.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::size_t begin, std::endian order, std::string_view name)
      : bytes_(bytes), name_(name), position_(begin), swap_(order != std::endian::native) {}

  template <class Number>
  Number read() {
    if (remaining() < sizeof(Number)) fail("the file ends within a value");
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data() + position_, sizeof(Number));
    if (swap_) std::reverse(raw.begin(), raw.end());
    position_ += sizeof(Number);
    return std::bit_cast<Number>(raw);
  }

  /// Passes over bytes, of which there must be enough.
  void skip(std::size_t count) { position_ += count; }
  std::size_t position() const { return position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  std::string_view rest() const { return bytes_.substr(position_); }

  [[noreturn]] void fail(const std::string& reason) const {
    throw MeshError(std::string(name_) + ":byte " + std::to_string(position_) + ": " + reason);
  }

 private:
  std::string_view bytes_;
  std::string_view name_;
  std::size_t position_;
  bool swap_;
};

/// Appends a number, least significant byte first.
template <class Number>
void append_little_endian(std::string& out, Number value) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  out.append(raw.data(), raw.size());
}

}  // namespace rectilin
