#include "writer_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "rectilin/base/system_reason.h"

namespace rectilin::corpus {

WriterLock::WriterLock(const std::filesystem::path& store)
    : file_(open((store.string() + "-lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw std::runtime_error(store.string() + ": cannot be written: " + system_reason(errno));
  if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(file_);
  throw std::runtime_error(store.string() + ": another program is writing to it");
}

WriterLock::~WriterLock() { close(file_); }

}  // namespace rectilin::corpus
