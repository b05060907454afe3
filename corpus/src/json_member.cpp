#include "json_member.h"

#include <algorithm>

namespace rectilin::corpus {
namespace {

/// Where the string that begins at `at` with a quotation mark ends, behind its closing one.
std::size_t end_of_string(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at)
    if (json[at] == '\\') ++at;
  return std::min(at + 1, json.size());
}

/// Where the value that begins at `at` ends.
std::size_t end_of_value(std::string_view json, std::size_t at) {
  int depth = 0;
  for (; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '"') {
      at = end_of_string(json, at) - 1;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      if (depth-- == 0) return at;
    } else if (c == ',' && depth == 0) {
      return at;
    }
  }
  return at;
}

}  // namespace

std::string_view member_of(std::string_view object, std::string_view name) {
  for (std::size_t at = 1; at < object.size() && object[at] == '"';) {
    const std::size_t colon = end_of_string(object, at), end = end_of_value(object, std::min(colon + 1, object.size()));
    if (colon < object.size() && object.substr(at + 1, colon - at - 2) == name)
      return object.substr(colon + 1, end - colon - 1);
    at = end + 1;
  }
  return {};
}

}  // namespace rectilin::corpus
