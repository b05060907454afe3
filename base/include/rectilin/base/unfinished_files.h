// Files that are being written under names of their own, so that nothing is left of them when a signal ends the
// program.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace rectilin {

/// A new file in a folder that no other program knows, open for writing. It goes away with this object unless it has
/// become something.
///
/// Where the system can, it has no name until it becomes something: then not even SIGKILL leaves it behind. Else it
/// is called `.rectilin-` and 16 random digits, a name that is free when it is chosen: nobody's file is touched, and
/// the name is short enough wherever files can be made.
class UnfinishedFile {
 public:
  /// `named` forbids the way without a name. Throws std::system_error.
  explicit UnfinishedFile(const std::filesystem::path& folder, bool named = false);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool named() const { return !name_.empty(); }

  /// Gives the file a name of its own if it has none; false if the system cannot do that.
  bool take_name();
  /// Takes the place of `file`, which must be in the folder. The file must have a name. Throws std::system_error.
  void become(const std::filesystem::path& file);

 private:
  void choose_name();
  void forget_name();

  std::filesystem::path folder_;
  std::string name_;  ///< path; empty if it has none
  std::size_t slot_;  ///< where remove_unfinished_files() finds the name
  int descriptor_ = -1;
};

/// Removes all that have a name. Async-signal-safe: for handlers of signals that end the program.
void remove_unfinished_files() noexcept;

}  // namespace rectilin
