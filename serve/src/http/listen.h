// A socket that listens.
#pragma once

#include <cstdint>
#include <string>

namespace rectilin::serve {

struct Listener {
  int socket;
  std::uint16_t port;  ///< the one asked for or, for 0, the one that was free
};

/// Listens on a numeric address, IPv4 or IPv6. Throws std::runtime_error, "ADDRESS:PORT: reason".
Listener listen_on(const std::string& address, std::uint16_t port);

/// "127.0.0.1:8000" or "[::1]:8000".
std::string with_port(const std::string& address, std::uint16_t port);

}  // namespace rectilin::serve
