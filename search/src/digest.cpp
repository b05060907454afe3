#include "rectilin/search/digest.h"

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "rectilin/base/fnv1a.h"
#include "rectilin/mesh/source.h"

namespace rectilin::search {

std::string file_of(const std::string& source) {
  if (is_shape_source(source)) return {};
  return source.substr(0, source.find("::"));
}

namespace {

/// load_mesh() knows why a source cannot be read, and says so.
[[noreturn]] void fail_as_reader(const std::string& source, const std::string& file) {
  load_mesh(source);
  throw std::runtime_error(file + ": cannot be read");
}

}  // namespace

std::string source_digest(const std::string& source) {
  std::ostringstream text;
  text << std::hex;
  const std::string file = file_of(source);
  if (file.empty()) {
    text << Fnv1a().add(source).value();
    return text.str();
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) fail_as_reader(source, file);
  // FNV-1a step by step over words, since bytes one by one would take longer than reading them.
  std::uint64_t hash = 0xcbf29ce484222325u, size = 0;
  std::vector<char> block(1 << 16);
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    std::memset(block.data() + count, 0, (8 - count % 8) % 8);
    for (std::size_t i = 0; i < count; i += 8) {
      std::uint64_t word;
      std::memcpy(&word, block.data() + i, 8);
      hash = (hash ^ word) * 0x100000001b3u;
      hash ^= hash >> 29;
    }
    size += count;
  }
  if (in.bad()) fail_as_reader(source, file);
  text << hash << '-' << size;
  if (file.size() < source.size()) text << '-' << Fnv1a().add(source.substr(file.size())).value();
  return text.str();
}

}  // namespace rectilin::search
