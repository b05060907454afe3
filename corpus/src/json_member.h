// A member of a JSON object that is kept as text, without parsing all of it.
#pragma once

#include <string_view>

namespace rectilin::corpus {

/// The text of the value of a member, `name` as it stands in the object; empty if there is none. Members of members do
/// not count. The object is as to_text() writes it: valid, and without blanks between its parts.
std::string_view member_of(std::string_view object, std::string_view name);

}  // namespace rectilin::corpus
