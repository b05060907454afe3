#include "worker_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace rectilin::corpus {
namespace {

constexpr int kWorkerSocket = 3, kWorkerShared = 4;

/// Runs in the child after fork(), where nothing may allocate memory.
[[noreturn]] void become_worker(char* const* arguments, int socket, int shared, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent ended before its end could be watched
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  setpgid(0, 0);  // Ctrl-C goes to the main program only, which then stops its workers
  const int nothing = open("/dev/null", O_RDWR);
  // Libraries may print complaints about broken files; users should not see them.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
  // First out of the way of each other's new numbers.
  const int far_socket = fcntl(socket, F_DUPFD_CLOEXEC, kWorkerShared + 1);
  const int far_shared = shared < 0 ? -1 : fcntl(shared, F_DUPFD_CLOEXEC, kWorkerShared + 1);
  dup2(far_socket, kWorkerSocket);
  if (shared >= 0) dup2(far_shared, kWorkerShared);
  execv(arguments[0], arguments);
  _exit(127);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string>& command, int shared) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::runtime_error(std::string("cannot make a socket for a worker: ") + std::strerror(errno));
  channel_ = std::make_unique<Channel>(ends[0]);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) become_worker(arguments.data(), ends[1], shared, parent);
  close(ends[1]);
  if (process_ < 0) throw std::runtime_error(std::string("cannot start a worker process: ") + std::strerror(errno));
}

WorkerProcess::~WorkerProcess() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

std::string WorkerProcess::wait_for_end() {
  int status = 0;
  pid_t done = 0;
  constexpr int kPatience = 1000;  // milliseconds that a worker has to end after its socket was closed
  for (int i = 0; i < kPatience && (done = waitpid(process_, &status, WNOHANG)) == 0; ++i) usleep(1000);
  if (done == 0) {
    kill(process_, SIGKILL);
    waitpid(process_, &status, 0);
  }
  process_ = -1;
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status)) + ", " + strsignal(WTERMSIG(status));
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace rectilin::corpus
