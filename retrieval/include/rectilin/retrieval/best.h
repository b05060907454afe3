// The descriptor to take if one has no reason for another.
#pragma once

#include <string>

namespace rectilin::retrieval {

/// What the descriptor `best` stands for: a text for make_descriptor(), the sum that is most discriminating of all we
/// know (papers/search.md).
const std::string& best_descriptor();

/// The text itself, or what it stands for if it is `best`.
inline const std::string& without_alias(const std::string& text) { return text == "best" ? best_descriptor() : text; }

}  // namespace rectilin::retrieval
