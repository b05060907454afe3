// A worker process, as the main program sees it.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include "channel.h"

namespace rectilin::corpus {

/// Runs a command as a child process; its file descriptor 3 is the other end of `channel`, and 4 is `shared` unless
/// that is negative. The child ends when this program ends, however that happens, and is killed when this object is
/// destroyed.
class WorkerProcess {
 public:
  /// Throws std::runtime_error if it cannot be started.
  explicit WorkerProcess(const std::vector<std::string>& command, int shared = -1);
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  Channel& channel() { return *channel_; }

  /// Waits for a worker that has closed its end and tells how it ended: "exit status 2" or "signal 11,
  /// Segmentation fault".
  std::string wait_for_end();

 private:
  pid_t process_ = -1;
  std::unique_ptr<Channel> channel_;
};

}  // namespace rectilin::corpus
