#include "rectilin/corpus/writer_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "rectilin/base/system_reason.h"

namespace rectilin::corpus {
namespace {

// If a program was killed while it was starting a process, that process holds its lock for a moment longer.
constexpr int kAttempts = 40;
constexpr std::chrono::milliseconds kPause(50);

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& store)
    : file_(open((store.string() + "-lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw std::runtime_error(store.string() + ": cannot be written: " + system_reason(errno));
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    std::this_thread::sleep_for(kPause);
  }
  close(file_);
  throw std::runtime_error(store.string() + ": another program is writing to it");
}

WriterLock::~WriterLock() { close(file_); }

bool is_being_written(const std::filesystem::path& store) {
  const int file = open((store.string() + "-lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool locked = flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(file);
  return locked;
}

}  // namespace rectilin::corpus
