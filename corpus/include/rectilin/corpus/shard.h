// A collection split among machines that need not know of each other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rectilin::corpus {

/// Part `index` of `count`, 0 <= index < count. Each name is in exactly one part, which depends on the name and the
/// count alone: parts can be run anywhere, in any order, and the rest of the collection may change.
struct Shard {
  std::uint32_t index = 0, count = 1;

  /// Reads "I/N", 0 <= I < N. Throws ParameterError.
  static Shard parse(std::string_view text);
  bool contains(std::string_view name) const;
  std::string to_string() const;
};

}  // namespace rectilin::corpus
