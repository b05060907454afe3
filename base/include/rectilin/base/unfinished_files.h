// Temporary files for atomic writes, which leave nothing behind when a signal ends the program.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace rectilin {

/// A new file in a folder, open for writing, which no other program knows of. Its destructor removes it unless become()
/// has turned it into the file it was meant to be.
///
/// On systems that can do so the file has no name until then, so that not even SIGKILL leaves it behind. Elsewhere it
/// is called `.rectilin-` and 16 random hexadecimal digits, a name that nothing else has when it is chosen and that is
/// short enough for any file system.
class UnfinishedFile {
 public:
  /// With `named` the file has a name from the beginning. Throws std::system_error if no file can be made.
  explicit UnfinishedFile(const std::filesystem::path& folder, bool named = false);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool named() const { return !name_.empty(); }

  /// Gives the file a name if it has none; returns false if the system cannot do that.
  bool take_name();
  /// Renames the file to `file`, in the same folder, replacing what is there. The file must have a name.
  /// Throws std::system_error.
  void become(const std::filesystem::path& file);

 private:
  void choose_name();
  void forget_name();

  std::filesystem::path folder_;
  std::string name_;  ///< its path; empty while it has no name
  std::size_t slot_;  ///< where the name is kept for remove_unfinished_files()
  int descriptor_ = -1;
};

/// Removes all unfinished files that have a name. Async-signal-safe: for handlers of signals that end the program.
void remove_unfinished_files() noexcept;

}  // namespace rectilin
