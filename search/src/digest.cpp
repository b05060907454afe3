#include "rectilin/search/digest.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "rectilin/base/fnv1a.h"
#include "rectilin/mesh/source.h"

namespace rectilin::search {
namespace {

std::string hexadecimal(std::uint64_t x) {
  std::ostringstream text;
  text << std::hex << x;
  return text.str();
}

}  // namespace

std::string file_of(const std::string& source) {
  if (is_shape_source(source)) return {};
  return source.substr(0, source.find("::"));
}

std::optional<std::string> file_digest(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  Fnv1aWords hash;  // bytes one by one would take longer than reading them
  std::uint64_t size = 0;
  std::vector<char> block(1 << 16);
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    hash.add(block.data(), count);
    size += count;
  }
  if (in.bad()) return std::nullopt;
  return hexadecimal(hash.value()) + '-' + hexadecimal(size);
}

std::string source_digest(const std::string& source, const std::string& digest) {
  const std::string file = file_of(source);
  if (file.empty()) return hexadecimal(Fnv1a().add(source).value());
  if (file.size() == source.size()) return digest;
  return digest + '-' + hexadecimal(Fnv1a().add(source.substr(file.size())).value());
}

std::string why_no_digest(const std::string& source) {
  try {
    load_mesh(source);
  } catch (const std::exception& e) {
    return e.what();
  }
  return file_of(source) + ": cannot be read";
}

}  // namespace rectilin::search
