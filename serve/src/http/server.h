// HTTP, with a bound for everything that a client decides.
//
// GNU libmicrohttpd does the protocol on one thread that never waits for a client, so that slow ones cost a connection
// and no thread; what takes long is done by a few workers meanwhile.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "http/message.h"

namespace rectilin::serve {

struct HttpLimits {
  std::size_t connections = 256;            ///< open at a time; more wait in the system's queue
  std::size_t header_bytes = 32 * 1024;     ///< of a request's first line and headers; also its buffer
  std::uint64_t body_bytes = 256u << 20;    ///< of one request
  std::uint64_t bodies_bytes = 512u << 20;  ///< of all requests at a time
  std::size_t workers = 4;
  std::size_t waiting = 512;           ///< requests that have arrived and wait for a worker
  std::chrono::seconds silence{10};    ///< a client that says nothing for so long is left
  std::chrono::seconds patience{20};   ///< for a request to arrive, however slowly it trickles
  std::chrono::seconds transfer{120};  ///< the same with a body, and for a response to be taken
};

class HttpServer {
 public:
  /// Listens on a numeric address (IPv4 or IPv6); port 0 is any that is free. Throws std::runtime_error, "ADDRESS:PORT:
  /// reason".
  HttpServer(const std::string& address, std::uint16_t port, const HttpLimits& limits, Service& service);
  /// Finishes the requests that are being worked on; those that wait are refused.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  std::uint16_t port() const;

  /// Hangs up on clients whose time is over; to be called every second or so.
  void sweep();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rectilin::serve
