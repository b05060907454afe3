// The lock of the one program that writes to a store.
#pragma once

#include <filesystem>
#include <string>

namespace rectilin::corpus {

/// One program at a time writes; a file of its own is locked, since SQLite locks the store's. It stays: removing it
/// would let two programs lock two files of one name.
class WriterLock {
 public:
  /// Waits for two seconds at most. Throws std::runtime_error if another program holds it still, or if the folder
  /// cannot be written.
  explicit WriterLock(const std::filesystem::path& store);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  int file_;
};

}  // namespace rectilin::corpus
