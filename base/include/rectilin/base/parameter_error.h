// The exception for a wrong name, setting or value given by the user.
#pragma once

#include <stdexcept>

namespace rectilin {

/// Thrown for an unknown name, an unknown setting or a value that is not accepted. what() is one line that says which
/// it was and what would be accepted.
class ParameterError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace rectilin
