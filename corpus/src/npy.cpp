#include "npy.h"

#include <cstdint>

namespace rectilin::corpus {

std::string npy_header(std::span<const std::string> fields, std::size_t rows) {
  std::string description = "{'descr': [";
  for (const std::string& field : fields) description += field + ", ";
  description += "], 'fortran_order': False, 'shape': (" + std::to_string(rows) + ",), }";
  constexpr std::size_t kPrefix = 10, kAlignment = 64;
  const std::size_t used = kPrefix + description.size() + 1;
  description.append((kAlignment - used % kAlignment) % kAlignment, ' ');
  description += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(description.size() & 0xff);
  header += static_cast<char>(description.size() >> 8);
  return header + description;
}

void append_bytes(std::string& out, std::string_view text, std::size_t size) {
  out.append(text.substr(0, size));
  out.append(size - std::min(size, text.size()), '\0');
}

}  // namespace rectilin::corpus
