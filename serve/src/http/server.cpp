#include "http/server.h"

#include <microhttpd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <mutex>
#include <stdexcept>
#include <unordered_map>

#include "http/listen.h"
#include "http/workers.h"
#include "rectilin/base/parameters.h"

namespace rectilin::serve {
namespace {

using Clock = std::chrono::steady_clock;

Response plain_error(int status, const std::string& text) {
  return {status, "application/json", to_bytes(to_text(Json{{"error", text}}))};
}

/// One request on its way through the library, which calls take() again and again with it.
struct Exchange {
  Request request;
  std::optional<Response> response;
  bool handed_over = false;   ///< to a worker
  std::uint64_t counted = 0;  ///< of the bytes that all bodies together may have
};

std::string text_of(const char* text, std::size_t size) { return text ? std::string(text, size) : std::string(); }

MHD_Result keep_argument(void* request, MHD_ValueKind, const char* key, std::size_t key_size, const char* value,
                         std::size_t value_size) {
  static_cast<Request*>(request)->arguments.emplace(text_of(key, key_size), text_of(value, value_size));
  return MHD_YES;
}

MHD_Result keep_header(void* request, MHD_ValueKind, const char* key, std::size_t key_size, const char* value,
                       std::size_t value_size) {
  std::string name = text_of(key, key_size);
  std::ranges::transform(name, name.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  static_cast<Request*>(request)->headers.emplace(std::move(name), text_of(value, value_size));
  return MHD_YES;
}

MHD_Result send(MHD_Connection* connection, const Response& response) {
  auto* kept = new Bytes(response.body ? response.body : to_bytes(""));
  MHD_Response* sent = MHD_create_response_from_buffer_with_free_callback_cls(
      (*kept)->size(), const_cast<char*>((*kept)->data()), [](void* bytes) { delete static_cast<Bytes*>(bytes); },
      kept);
  if (!sent) {
    delete kept;
    return MHD_NO;
  }
  if (!response.type.empty()) MHD_add_response_header(sent, MHD_HTTP_HEADER_CONTENT_TYPE, response.type.c_str());
  for (const auto& [name, value] : response.headers) MHD_add_response_header(sent, name.c_str(), value.c_str());
  const MHD_Result result = MHD_queue_response(connection, static_cast<unsigned>(response.status), sent);
  MHD_destroy_response(sent);
  return result;
}

}  // namespace

struct HttpServer::Implementation {
  HttpLimits limits;
  Service& service;
  Listener listener{-1, 0};
  std::atomic<bool> ending = false;
  std::atomic<std::uint64_t> bodies = 0;
  MHD_Daemon* daemon = nullptr;
  std::unique_ptr<Workers> workers;

  /// How long each open connection has been in its present state.
  struct Deadline {
    int socket;
    Clock::time_point until;
  };
  std::mutex mutex;
  std::unordered_map<MHD_Connection*, Deadline> deadlines;

  void give(MHD_Connection* connection, std::chrono::seconds time) {
    const std::lock_guard lock(mutex);
    if (const auto found = deadlines.find(connection); found != deadlines.end())
      found->second.until = Clock::now() + time;
  }

  /// What is wrong with a request whatever its service, before its body is read.
  std::optional<Response> out_of_bounds(Exchange& exchange) {
    Request& r = exchange.request;
    if (ending) return plain_error(503, "the server is stopping");
    if (r.headers.contains("transfer-encoding")) return plain_error(411, "a body needs a Content-Length");
    const std::string length = r.header("content-length");
    if (!length.empty()) {
      const auto [end, error] = std::from_chars(length.data(), length.data() + length.size(), r.length);
      if (error == std::errc::result_out_of_range) return plain_error(413, "the body is too large");
      if (error != std::errc() || end != length.data() + length.size())
        return plain_error(400, "Content-Length is not a number");
    }
    if (r.length > limits.body_bytes)
      return plain_error(413, "the file is larger than " + std::to_string(limits.body_bytes >> 20) + " MiB");
    if (bodies.fetch_add(r.length) + r.length > limits.bodies_bytes) {
      bodies -= r.length;
      return plain_error(503, "too many uploads at a time; try again");
    }
    exchange.counted = r.length;
    return std::nullopt;
  }

  MHD_Result take(MHD_Connection* connection, Exchange& exchange, const char* data, std::size_t* size) {
    if (*size > 0) {
      // The library stops at Content-Length; this is the same bound once more.
      if (exchange.request.body.size() + *size > exchange.request.length) return MHD_NO;
      exchange.request.body.append(data, *size);
      *size = 0;
      return MHD_YES;
    }
    if (exchange.response) {
      give(connection, limits.transfer);
      return send(connection, *exchange.response);
    }
    if (exchange.handed_over) return MHD_NO;
    exchange.handed_over = true;
    give(connection, std::chrono::hours(1));  // tasks have bounds of their own
    MHD_suspend_connection(connection);
    const bool accepted = workers->add([this, connection, &exchange] {
      try {
        exchange.response = ending ? plain_error(503, "the server is stopping") : service.answer(exchange.request);
      } catch (const std::exception&) {
        exchange.response = plain_error(500, "the server could not answer");
      }
      MHD_resume_connection(connection);
    });
    if (!accepted) {
      exchange.response = plain_error(503, "too many requests at a time; try again");
      MHD_resume_connection(connection);
    }
    return MHD_YES;
  }

  MHD_Result first(MHD_Connection* connection, Exchange& exchange, const char* url, const char* method) {
    Request& r = exchange.request;
    r.method = method;
    r.path = url;
    MHD_get_connection_values_n(connection, MHD_GET_ARGUMENT_KIND, keep_argument, &r);
    MHD_get_connection_values_n(connection, MHD_HEADER_KIND, keep_header, &r);
    std::optional<Response> refused = out_of_bounds(exchange);
    if (!refused) refused = service.refuse(r);
    if (refused) {
      give(connection, limits.patience);
      return send(connection, *refused);
    }
    if (r.length > 0) give(connection, limits.transfer);
    return MHD_YES;
  }

  // What the library calls.

  static MHD_Result access(void* self, MHD_Connection* connection, const char* url, const char* method, const char*,
                           const char* data, std::size_t* size, void** state) {
    auto& own = *static_cast<Implementation*>(self);
    try {
      if (*state) return own.take(connection, *static_cast<Exchange*>(*state), data, size);
      auto exchange = std::make_unique<Exchange>();
      *state = exchange.get();
      return own.first(connection, *exchange.release(), url, method);
    } catch (const std::exception&) {  // no memory
      return MHD_NO;
    }
  }

  static void completed(void* self, MHD_Connection* connection, void** state, MHD_RequestTerminationCode) {
    auto& own = *static_cast<Implementation*>(self);
    if (auto* exchange = static_cast<Exchange*>(*state)) {
      own.bodies -= exchange->counted;
      delete exchange;
    }
    *state = nullptr;
    own.give(connection, own.limits.patience);  // for the next request
  }

  static void connected(void* self, MHD_Connection* connection, void**, MHD_ConnectionNotificationCode code) {
    auto& own = *static_cast<Implementation*>(self);
    const std::lock_guard lock(own.mutex);
    if (code == MHD_CONNECTION_NOTIFY_STARTED) {
      const auto* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
      own.deadlines[connection] = {info ? info->connect_fd : -1, Clock::now() + own.limits.patience};
    } else {
      own.deadlines.erase(connection);  // before the library closes the socket, whose number is then another's
    }
  }
};

HttpServer::HttpServer(const std::string& address, std::uint16_t port, const HttpLimits& limits, Service& service)
    : implementation_(std::make_unique<Implementation>(limits, service)) {
  Implementation& own = *implementation_;
  own.listener = listen_on(address, port);
  own.workers = std::make_unique<Workers>(limits.workers, limits.waiting);
  own.daemon = MHD_start_daemon(MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr,
                                &Implementation::access, &own, MHD_OPTION_LISTEN_SOCKET, own.listener.socket,
                                MHD_OPTION_CONNECTION_LIMIT, static_cast<unsigned>(limits.connections),
                                MHD_OPTION_CONNECTION_MEMORY_LIMIT, limits.header_bytes, MHD_OPTION_CONNECTION_TIMEOUT,
                                static_cast<unsigned>(limits.silence.count()), MHD_OPTION_STRICT_FOR_CLIENT, 1,
                                MHD_OPTION_NOTIFY_COMPLETED, &Implementation::completed, &own,
                                MHD_OPTION_NOTIFY_CONNECTION, &Implementation::connected, &own, MHD_OPTION_END);
  if (!own.daemon) {
    close(own.listener.socket);
    throw std::runtime_error(with_port(address, own.listener.port) + ": the server cannot be started");
  }
}

HttpServer::~HttpServer() {
  // Nothing may be suspended when the daemon stops, so the workers answer all that waits first; later requests are
  // refused at once, since `ending` is set.
  Implementation& own = *implementation_;
  own.ending = true;
  own.workers->finish();
  MHD_stop_daemon(own.daemon);
}

std::uint16_t HttpServer::port() const { return implementation_->listener.port; }

void HttpServer::sweep() {
  Implementation& own = *implementation_;
  const auto now = Clock::now();
  const std::lock_guard lock(own.mutex);
  for (const auto& [connection, deadline] : own.deadlines)
    if (deadline.until < now && deadline.socket >= 0) shutdown(deadline.socket, SHUT_RDWR);
}

}  // namespace rectilin::serve
