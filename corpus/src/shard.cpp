#include "rectilin/corpus/shard.h"

#include <charconv>

#include "rectilin/base/fnv1a.h"
#include "rectilin/base/parameters.h"

namespace rectilin::corpus {
namespace {

/// Mixes the bits of the hash: the upper bits of FNV-1a, which decide the shard, hardly depend on the last letters of a
/// name (this is the finalizer of MurmurHash3).
std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdu;
  x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53u;
  return x ^ (x >> 33);
}

bool read(std::string_view text, std::uint32_t& x) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

Shard Shard::parse(std::string_view text) {
  Shard shard;
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos || !read(text.substr(0, slash), shard.index) ||
      !read(text.substr(slash + 1), shard.count) || shard.index >= shard.count)
    throw ParameterError("shard '" + std::string(text) + "' is not I/N with 0 <= I < N");
  return shard;
}

bool Shard::contains(std::string_view name) const {
  // The upper half of the product of two 32-bit numbers divides the range of hashes into equal parts.
  return ((mix(Fnv1a().add(name).value()) >> 32) * count) >> 32 == index;
}

std::string Shard::to_string() const { return std::to_string(index) + '/' + std::to_string(count); }

}  // namespace rectilin::corpus
