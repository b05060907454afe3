#include "rectilin/base/system_reason.h"

namespace rectilin {

std::string system_reason(int error_number) {
  std::string words = std::generic_category().message(error_number);
  // Only ordinary words lose their capital: "Permission denied" does, "I/O error" does not.
  const bool word = words.size() > 1 && words[0] >= 'A' && words[0] <= 'Z' && words[1] >= 'a' && words[1] <= 'z';
  if (word) words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

}  // namespace rectilin
