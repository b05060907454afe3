// Reading a whole file at once, and atomic writes: the whole file or none of it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>

namespace rectilin {

/// All bytes of a file, a pipe or a socket; a pipe is read to its end. Devices are refused, as some never end. Throws
/// std::runtime_error, "FILE: " and the system's reason.
std::string read_whole_file(const std::filesystem::path& file);

/// Why there is no file to be read, for libraries that open files by themselves and keep the reason from us; no error
/// if there is one. A folder is none.
std::error_code why_unreadable(const std::filesystem::path& file);

/// Writes a file under another name in the same folder and renames it at the end (see UnfinishedFile), so that a full
/// disk or an end of the program in between neither leaves half of it nor destroys what was there. What it replaces
/// hands on its permissions and must be writable; a link stays, and the file it leads to is replaced. Pipes, devices
/// and links to nowhere are written in place. Throws std::runtime_error, "FILE: cannot be written: " and the system's
/// reason.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

/// The same for a file that is written piece by piece, as it is too large to be in memory: it takes its name in
/// finish(), and without that nothing has changed. All throw as write_whole_file() does.
class GrowingFile {
 public:
  explicit GrowingFile(const std::filesystem::path& file);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void write(std::string_view piece);
  void finish();

 private:
  std::filesystem::path file_;
  std::function<void(std::string_view)> write_;
  std::function<void()> finish_;
};

}  // namespace rectilin
