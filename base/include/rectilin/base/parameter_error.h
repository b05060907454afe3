// The error of a wrong name, key or value.
#pragma once

#include <stdexcept>

namespace rectilin {

/// A wrong name, key or value. what() is one line that says which, and what would be accepted.
class ParameterError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace rectilin
