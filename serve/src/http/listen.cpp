#include "http/listen.h"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "rectilin/base/system_reason.h"

namespace rectilin::serve {

std::string with_port(const std::string& address, std::uint16_t port) {
  const std::string host = address.find(':') == std::string::npos ? address : "[" + address + "]";
  return host + ":" + std::to_string(port);
}

Listener listen_on(const std::string& address, std::uint16_t port) {
  const std::string name = with_port(address, port);
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(address.c_str(), std::to_string(port).c_str(), &hints, &found) != 0)
    throw std::runtime_error(name + ": not an address of numbers such as 127.0.0.1, 0.0.0.0 or ::1");
  const int s = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  // A port is free again as soon as its server has ended, whatever connections linger.
  if (s >= 0) setsockopt(s, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const bool listens = s >= 0 && bind(s, found->ai_addr, found->ai_addrlen) == 0 && listen(s, SOMAXCONN) == 0;
  const int error = errno;
  freeaddrinfo(found);
  sockaddr_storage own{};
  socklen_t size = sizeof own;
  if (!listens || getsockname(s, reinterpret_cast<sockaddr*>(&own), &size) != 0) {
    if (s >= 0) close(s);
    throw std::runtime_error(
        name + ": " + (error == EADDRINUSE ? "the port is in use; --port 0 finds another" : system_reason(error)));
  }
  const in_port_t at = own.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(own).sin6_port
                                                 : reinterpret_cast<const sockaddr_in&>(own).sin_port;
  return {s, ntohs(at)};
}

}  // namespace rectilin::serve
