#include "child/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "rectilin/base/system_reason.h"

extern char** environ;

namespace rectilin::serve {
namespace {

/// A descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {
    if (number < 0) throw ChildError("the system gives no more files: " + system_reason(errno));
  }
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return number_; }

 private:
  int number_;
};

void write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = pwrite(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (n <= 0) throw ChildError("no memory for the request");
    done += static_cast<std::size_t>(n);
  }
}

std::string read_all(int file) {
  struct stat about {};
  if (fstat(file, &about) != 0) throw ChildError("the answer cannot be read");
  std::string bytes(static_cast<std::size_t>(about.st_size), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (n <= 0) throw ChildError("the answer cannot be read");
    done += static_cast<std::size_t>(n);
  }
  return bytes;
}

/// posix_spawn() shares this program's memory until the child runs its own, so that it is quick however much there is.
pid_t spawn(const std::vector<std::string>& command, int in, int out) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  // Libraries may print complaints about broken files; users should not see them.
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);  // Ctrl-C is for the server
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  pid_t child = -1;
  const int error = posix_spawn(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw ChildError("a process cannot be started: " + system_reason(error));
  return child;
}

}  // namespace

std::string run_child(const std::vector<std::string>& command, const std::string& input, const ChildLimits& limits,
                      const std::function<bool()>& stop) {
  using Clock = std::chrono::steady_clock;
  const Descriptor in(memfd_create("request", MFD_CLOEXEC)), out(memfd_create("answer", MFD_CLOEXEC));
  write_all(in, input);
  const auto until = Clock::now() + limits.time;
  const pid_t child = spawn(command, in, out);
  const char* killed = nullptr;
  {
    // -1 where the system has no such call: poll() is then a pause.
    const int process = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
    constexpr int kLook = 50;  // milliseconds
    pollfd ended{process, POLLIN, 0};
    for (;;) {
      siginfo_t info{};
      waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT);
      if (info.si_pid == child) break;
      if (stop()) killed = "stopped";
      if (Clock::now() > until) killed = "took too long";
      if (killed) {
        kill(child, SIGKILL);
        break;
      }
      poll(&ended, 1, process < 0 ? 2 : kLook);
    }
    if (process >= 0) close(process);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (killed) throw ChildError(killed);
  if (WIFSIGNALED(status))
    throw ChildError(WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL ? "took too much time or memory"
                                                                                : "the reader crashed");
  if (WEXITSTATUS(status) != 0) throw ChildError("could not be worked on");
  return read_all(out);
}

void limit_this_process(const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const auto set = [](auto what, std::uint64_t most) {
    const rlimit limit{most, most};
    setrlimit(what, &limit);
  };
  set(RLIMIT_CORE, 0);
  set(RLIMIT_DATA, limits.memory);
  set(RLIMIT_FSIZE, limits.output);
  // The clock is the parent's; this is for the case that it is gone. All threads count.
  set(RLIMIT_CPU, static_cast<std::uint64_t>(limits.time.count()) * 64);
}

}  // namespace rectilin::serve
