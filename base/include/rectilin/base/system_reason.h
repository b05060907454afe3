// Why the operating system refused something, in its own words.
#pragma once

#include <cerrno>
#include <string>
#include <system_error>

namespace rectilin {

/// The system's message for an error number, in small letters so that it can follow a colon: "permission denied", "file
/// name too long", "no space left on device".
std::string system_reason(int error_number);

inline std::string system_reason(const std::error_code& error) {
  return error.category() == std::system_category() || error.category() == std::generic_category()
             ? system_reason(error.value())
             : error.message();
}

}  // namespace rectilin
