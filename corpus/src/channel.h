// Messages between the program and its workers, over a socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rectilin::corpus {

/// What a message is. Its content is text; names of files are sent as they are, whatever their encoding.
enum class Kind : char {
  kSetup = 'S',     ///< to a worker, once: JSON {task, settings, memory}
  kMesh = 'M',      ///< to a worker: the source of a mesh
  kMeasure = 'G',   ///< to a worker: the digest is new, go on
  kKnown = 'K',     ///< to a worker: it is not, leave the mesh
  kRead = 'D',      ///< from a worker: JSON {digest, report}
  kResult = 'R',    ///< from a worker: JSON {result, time_over}
  kError = 'E',     ///< from a worker: why there is none
  kNoMemory = 'L',  ///< from a worker, which then ends: the memory allowed is not enough
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

  /// False if the other end is gone.
  bool send(Kind kind, std::string_view content);

  /// The next message; waits for it. Nothing if the other end is gone or sends what is none.
  std::optional<Message> receive();

  /// Takes what has come; false if the other end is gone. Does not wait.
  bool fill();
  /// The next message that has come as a whole.
  std::optional<Message> next();

 private:
  int socket_;
  bool broken_ = false;
  std::string buffer_;
};

}  // namespace rectilin::corpus
