// A forward declaration of the project's JSON type, for headers that only mention it: the full header takes seconds to
// compile. parameters.h includes the definition.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace rectilin {

/// Objects keep their keys in the order in which they were added.
using Json = nlohmann::ordered_json;

/// The value as text: on one line, or indented by `indent` spaces. Bytes that are not UTF-8, which file names may
/// contain, are replaced.
std::string to_text(const Json& value, int indent = -1);

}  // namespace rectilin
