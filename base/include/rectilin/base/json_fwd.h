// The project's JSON value, declared: for headers that only name it. parameters.h defines it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rectilin {

/// An object keeps its keys in the order in which they were written.
using Json = nlohmann::ordered_json;

/// On one line or indented. Bytes that are not UTF-8, as names of files may have, are replaced.
std::string to_text(const Json& value, int indent = -1);

}  // namespace rectilin
