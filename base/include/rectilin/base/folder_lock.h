// A lock on a folder, so that two programs do not write into it at once.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>

namespace rectilin {

/// Holds the lock as long as it lives. The system releases it when the program ends, however it ends.
class FolderLock {
 public:
  /// Throws std::runtime_error if another program holds the folder. A folder that cannot be locked, as on some network
  /// file systems, is used without a lock.
  explicit FolderLock(const std::filesystem::path& folder) : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {
    if (file_ < 0 || flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(file_);
    throw std::runtime_error(folder.string() + ": another program is writing here");
  }
  ~FolderLock() {
    if (file_ >= 0) close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace rectilin
