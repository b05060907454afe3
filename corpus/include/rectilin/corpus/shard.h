// Splits a collection into parts for machines that do not talk to each other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rectilin::corpus {

/// Part `index` of `count`, 0 <= index < count. Each name belongs to exactly one part, which depends on the name and
/// the count alone: parts can be run anywhere and in any order, and adding meshes moves no others.
struct Shard {
  std::uint32_t index = 0, count = 1;

  /// Reads "I/N" with 0 <= I < N. Throws ParameterError for any other text.
  static Shard parse(std::string_view text);
  bool contains(std::string_view name) const;
  std::string to_string() const;
};

}  // namespace rectilin::corpus
