#include "rectilin/retrieval/lfd_files.h"

#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "rectilin/base/whole_file.h"

namespace rectilin::retrieval {
namespace {

// In the signature's order.
constexpr std::array<std::pair<const char*, std::size_t>, 4> kLfdFiles{
    {{".art", 3500}, {".fd", 1000}, {".cir", 100}, {".ecc", 100}}};

}  // namespace

void write_lfd_files(const std::filesystem::path& base, SignatureView signature) {
  std::size_t sum = 0;
  for (const auto& [extension, bytes] : kLfdFiles) sum += bytes;
  if (signature.size() != sum)
    throw std::invalid_argument("a signature of lfd:ntu has " + std::to_string(sum) + " bytes, not " +
                                std::to_string(signature.size()));
  std::size_t at = 0;
  for (const auto& [extension, bytes] : kLfdFiles) {
    const SignatureView part = signature.subspan(at, bytes);
    write_whole_file(base.string() + extension, std::string(part.begin(), part.end()));
    at += bytes;
  }
}

Signature read_lfd_files(const std::filesystem::path& base) {
  Signature signature;
  for (const auto& [extension, bytes] : kLfdFiles) {
    const std::string file = base.string() + extension;
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in) throw std::runtime_error(file + ": cannot be read");
    if (text.size() != bytes)
      throw std::runtime_error(file + ": has " + std::to_string(text.size()) + " bytes, not " + std::to_string(bytes));
    for (const char c : text) signature.push_back(static_cast<std::uint8_t>(c));
  }
  return signature;
}

}  // namespace rectilin::retrieval
