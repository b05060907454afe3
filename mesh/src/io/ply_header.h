// The header of a PLY file: which elements follow, with which properties.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "io/text.h"

namespace rectilin {
namespace ply {

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };
enum class Encoding { kText, kLittleEndian, kBigEndian };

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> count_type;  // of a list
};

struct Element {
  std::string_view name;
  std::size_t count;
  std::size_t line;  // of the header
  std::vector<Property> properties;
};

struct PlyHeader {
  std::optional<Encoding> encoding;
  std::vector<Element> elements;
};

/// Bytes of a value in binary data.
std::size_t size_of(Type type);

/// Reads up to the word end_header, whose line is then not yet left. Names refer to the text.
PlyHeader read_ply_header(LineReader& text);

/// The first byte after the line of end_header, for binary data.
std::size_t body_offset(const LineReader& text, std::string_view bytes);

}  // namespace ply
}  // namespace rectilin
