// A lock that lets only one program write to a store.
#pragma once

#include <filesystem>
#include <string>

namespace rectilin::corpus {

/// SQLite locks the store itself, so this locks a file beside it. That file is never removed: if it were, two programs
/// could hold locks on two different files of that name.
class WriterLock {
 public:
  /// Waits for up to two seconds. Throws std::runtime_error if another program still holds it, or if the folder cannot
  /// be written.
  explicit WriterLock(const std::filesystem::path& store);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  int file_;
};

/// Does a program on this machine hold the lock of a store?
bool is_being_written(const std::filesystem::path& store);

}  // namespace rectilin::corpus
