// Messages between the program and its workers, over a socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rectilin/mesh/source.h"

namespace rectilin::corpus {

/// The kinds of messages. A worker has up to two meshes at a time and does them in their order. It ends each with one
/// of the messages from kResult on, except those that it is told not to go on with. Workers that share claims say what
/// they have read; only of a mesh that another job has claimed they ask whether to go on.
enum class Kind : char {
  kSetup = 'S',     ///< to a worker, once: JSON {task, settings, seconds, memory, share}
  kMesh = 'M',      ///< to a worker: job_message()
  kCancel = 'C',    ///< to a worker: the last mesh sent is not wanted any more, unless it was begun
  kGoOn = 'G',      ///< to a worker that asks: do the work
  kKnown = 'K',     ///< to a worker that asks: a mesh with this digest is known, skip this one
  kRead = 'D',      ///< from a worker that shares claims: JSON {digest, report, left_out}
  kAsk = 'A',       ///< the same, and it waits for an answer
  kResult = 'R',    ///< from a worker: JSON {result, time_over, read}, then, after NUL, the bytes of the result if any
  kError = 'E',     ///< from a worker: why there is no result
  kSkipped = 'X',   ///< from a worker: the mesh was cancelled in time
  kNoMemory = 'L',  ///< from a worker, which then ends: it reached its memory limit
};

struct Message {
  Kind kind;
  std::string content;
};

/// A job's number and its mesh with name and class, byte for byte, whatever their encoding.
struct MeshJob {
  std::size_t number = 0;
  NamedSource mesh;
  bool operator==(const MeshJob&) const = default;
};
std::string job_message(std::size_t number, const NamedSource& mesh);
MeshJob job_in(std::string_view message);

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
