#include "channel.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>

namespace rectilin::corpus {
namespace {

constexpr std::size_t kHeader = 5;  // the length and the kind
constexpr std::size_t kLongest = std::size_t{1} << 28;

}  // namespace

std::string job_message(std::size_t number, const NamedSource& mesh) {
  return std::to_string(number) + ' ' + std::to_string(mesh.name.size()) + ' ' + std::to_string(mesh.group.size()) +
         ' ' + mesh.name + mesh.group + mesh.source;
}

MeshJob job_in(std::string_view message) {
  std::size_t number = 0, name_size = 0, group_size = 0;
  for (std::size_t* const n : {&number, &name_size, &group_size}) {
    const char* const end = std::from_chars(message.data(), message.data() + message.size(), *n).ptr;
    message.remove_prefix(std::min(static_cast<std::size_t>(end - message.data()) + 1, message.size()));
  }
  const std::string_view name = message.substr(0, name_size);
  message.remove_prefix(name.size());
  const std::string_view group = message.substr(0, group_size);
  message.remove_prefix(group.size());
  return {number, {std::string(name), std::string(message), std::string(group)}};
}

Channel::~Channel() {
  if (socket_ >= 0) close(socket_);
}

bool Channel::send(Kind kind, std::string_view content) {
  std::string message(kHeader, static_cast<char>(kind));
  const auto length = static_cast<std::uint32_t>(content.size());
  std::memcpy(message.data(), &length, sizeof length);  // in the byte order of the machine: both ends run on it
  message += content;
  for (std::string_view rest = message; !rest.empty();) {
    const ssize_t sent = ::send(socket_, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

std::optional<Message> Channel::receive() {
  for (;;) {
    if (auto message = next()) return message;
    pollfd wait{socket_, POLLIN, 0};
    if (poll(&wait, 1, -1) < 0 && errno != EINTR) return std::nullopt;
    if (!fill()) return std::nullopt;
  }
}

bool Channel::fill() {
  char bytes[1 << 16];
  for (;;) {
    const ssize_t got = recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return !broken_;
    if (got <= 0) return false;
    buffer_.append(bytes, static_cast<std::size_t>(got));
    if (static_cast<std::size_t>(got) < sizeof bytes) return !broken_;
  }
}

std::optional<Message> Channel::next() {
  if (broken_ || buffer_.size() < kHeader) return std::nullopt;
  std::uint32_t length = 0;
  std::memcpy(&length, buffer_.data(), sizeof length);
  if (length > kLongest) {
    broken_ = true;
    return std::nullopt;
  }
  if (buffer_.size() < kHeader + length) return std::nullopt;
  Message message{static_cast<Kind>(buffer_[kHeader - 1]), buffer_.substr(kHeader, length)};
  buffer_.erase(0, kHeader + length);
  return message;
}

}  // namespace rectilin::corpus
