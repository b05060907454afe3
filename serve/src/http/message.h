// Requests and responses, as the rest of the house sees them: nothing of the library that carries them.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rectilin::serve {

struct Request {
  std::string method, path;                      ///< the path without the part after '?', decoded
  std::map<std::string, std::string> arguments;  ///< what is after '?', decoded; the first of equal names
  std::map<std::string, std::string> headers;    ///< names in small letters; the first of equal names
  std::uint64_t length = 0;                      ///< of the body, as announced
  std::string body = {};

  std::string header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string() : found->second;
  }
  std::optional<std::string> argument(const std::string& name) const {
    const auto found = arguments.find(name);
    return found == arguments.end() ? std::nullopt : std::optional(found->second);
  }
};

/// Shared, so that what is in a cache is sent without a copy.
using Bytes = std::shared_ptr<const std::string>;

struct Response {
  int status = 200;
  std::string type;  ///< of the content
  Bytes body;
  std::vector<std::pair<std::string, std::string>> headers = {};
};

inline Bytes to_bytes(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

/// Answers requests. Both functions are called from several threads.
class Service {
 public:
  virtual ~Service() = default;
  /// Called before the body has arrived, so that one that nobody wants is not read; must be quick. A response that it
  /// returns ends the request.
  virtual std::optional<Response> refuse(const Request& request) = 0;
  /// May take its time, and throw.
  virtual Response answer(const Request& request) = 0;
};

}  // namespace rectilin::serve
