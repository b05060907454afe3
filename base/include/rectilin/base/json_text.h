// JSON from text and to text. The parser and the writer are compiled here, once: a source that makes its own compiles
// for a second longer.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rectilin/base/json_fwd.h"

namespace rectilin {

/// The value as text: on one line, or indented by `indent` spaces. Numbers read back as they were. Bytes that are not
/// UTF-8, which file names may contain, are replaced.
std::string to_text(const Json& value, int indent = -1);

/// Throws Json::parse_error, whose message says where, if the text is not one JSON value.
Json parse_json(std::string_view text);

/// Null if the text is not one JSON value.
Json parse_json_or_null(std::string_view text);

/// Null if the file cannot be read or is not one JSON value: for notes of earlier runs, which are used if they are
/// there.
Json read_json_or_null(const std::filesystem::path& file);

}  // namespace rectilin
