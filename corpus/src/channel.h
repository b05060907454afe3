// Messages between the program and its workers, over a socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rectilin::corpus {

/// The kinds of messages. Their content is text; file names are sent byte for byte, whatever their encoding.
enum class Kind : char {
  kSetup = 'S',     ///< to a worker, once: JSON {task, settings, memory}
  kMesh = 'M',      ///< to a worker: the source of a mesh
  kMeasure = 'G',   ///< to a worker: no mesh had this digest before, go on with it
  kKnown = 'K',     ///< to a worker: a mesh with this digest is known, skip this one
  kRead = 'D',      ///< from a worker: JSON {digest, report}
  kResult = 'R',    ///< from a worker: JSON {result, time_over}
  kError = 'E',     ///< from a worker: why there is no result
  kNoMemory = 'L',  ///< from a worker, which then ends: it reached its memory limit
};

struct Message {
  Kind kind;
  std::string content;
};

/// One end of a connection. Not thread safe.
class Channel {
 public:
  explicit Channel(int socket) : socket_(socket) {}
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  int socket() const { return socket_; }

  /// Returns false if the other end is gone.
  bool send(Kind kind, std::string_view content);

  /// Waits for the next message. Returns nothing if the other end is gone or sends something that is not a message.
  std::optional<Message> receive();

  /// Reads what has arrived, without waiting; returns false if the other end is gone.
  bool fill();
  /// The next message that has arrived completely.
  std::optional<Message> next();

 private:
  int socket_;
  bool broken_ = false;
  std::string buffer_;
};

}  // namespace rectilin::corpus
