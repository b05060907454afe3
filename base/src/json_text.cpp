#include "rectilin/base/json_text.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

namespace rectilin {

std::string to_text(const Json& value, int indent) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json parse_json(std::string_view text) { return Json::parse(text); }

Json parse_json_or_null(std::string_view text) {
  Json value = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  return value.is_discarded() ? Json() : value;
}

Json read_json_or_null(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return parse_json_or_null(std::string(std::istreambuf_iterator<char>(in), {}));
}

}  // namespace rectilin
