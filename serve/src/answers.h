// Small pieces of answers.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "http/message.h"
#include "rectilin/base/parameters.h"

namespace rectilin::serve {

/// Ends the work on a request with a status and a line that says why.
class Refusal : public std::runtime_error {
 public:
  Refusal(int status, const std::string& why) : std::runtime_error(why), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

Response json_response(const Json& json, int status = 200);
Response error_response(int status, const std::string& why);

/// A whole number in an argument, `otherwise` if there is none. Throws Refusal if it is out of range or no number.
std::uint64_t number_argument(const Request& request, const std::string& name, std::uint64_t otherwise,
                              std::uint64_t least, std::uint64_t most);
/// Throws Refusal if it is missing.
std::string needed_argument(const Request& request, const std::string& name);

/// A name of 128 random bits, which nobody can guess.
std::string random_name();

}  // namespace rectilin::serve
