#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <string>

namespace rectilin::ply {
namespace {

Type parse_type(LineReader& text) {
  struct Name {
    std::string_view original, sized;
  };
  constexpr std::array<Name, 8> kNames = {{{"char", "int8"},
                                           {"uchar", "uint8"},
                                           {"short", "int16"},
                                           {"ushort", "uint16"},
                                           {"int", "int32"},
                                           {"uint", "uint32"},
                                           {"float", "float32"},
                                           {"double", "float64"}}};
  const std::string_view word = text.word();
  const auto found = std::find_if(kNames.begin(), kNames.end(),
                                  [&](const Name& name) { return word == name.original || word == name.sized; });
  if (found == kNames.end()) text.fail_expected("a type", word);
  return static_cast<Type>(found - kNames.begin());
}

Encoding parse_encoding(LineReader& text) {
  const std::string_view word = text.word();
  if (word == "ascii") return Encoding::kText;
  if (word == "binary_little_endian") return Encoding::kLittleEndian;
  if (word == "binary_big_endian") return Encoding::kBigEndian;
  text.fail_expected("ascii, binary_little_endian or binary_big_endian", word);
}

Property parse_property(LineReader& text) {
  Property property{};
  const std::string_view word = text.word();
  if (word == "list") {
    property.count_type = parse_type(text);
    if (*property.count_type >= Type::kFloat32) text.fail("a list whose count is no integer");
  } else {
    text.unread(word.size());
  }
  property.type = parse_type(text);
  property.name = text.word();
  if (property.name.empty()) text.fail_expected("a property's name", {});
  return property;
}

Element parse_element(LineReader& text) {
  const std::string_view name = text.word();
  const std::int64_t count = text.integer("an element's name and count");
  if (count < 0) text.fail("a negative count of elements");
  return {name, static_cast<std::size_t>(count), text.line(), {}};
}

}  // namespace

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(LineReader& text) {
  if (!text.next_line() || text.word() != "ply") text.fail("expected ply on the first line");
  PlyHeader header;
  while (text.next_line()) {
    const std::string_view keyword = text.word();
    if (keyword == "end_header") {
      if (!header.encoding) text.fail("the header has no line format");
      return header;
    }
    if (keyword == "format") {
      header.encoding = parse_encoding(text);
    } else if (keyword == "element") {
      header.elements.push_back(parse_element(text));
    } else if (keyword == "property") {
      if (header.elements.empty()) text.fail("a property before any element");
      header.elements.back().properties.push_back(parse_property(text));
    } else if (keyword != "comment" && keyword != "obj_info") {
      text.fail_expected("a header line", keyword);
    }
  }
  text.fail("the file ends within the header");
}

// Binary data may begin with a byte that looks like half of a line ending, so the lines before tell
// how lines end.
std::size_t body_offset(const LineReader& text, std::string_view bytes) {
  const std::size_t end = bytes.find(text.line_ending(), text.offset());
  return end == std::string_view::npos ? bytes.size() : end + 1;
}

}  // namespace rectilin::ply
