// A forward declaration of the project's JSON type, for headers that only mention it: the full header takes seconds to
// compile. parameters.h includes the definition.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace rectilin {

/// Objects keep their keys in the order in which they were added.
using Json = nlohmann::ordered_json;

}  // namespace rectilin
