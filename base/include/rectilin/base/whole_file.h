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

/// Why a file cannot be read, for libraries that open files themselves and do not pass the reason on; no error if it
/// can be read. A folder is not a file.
std::error_code why_unreadable(const std::filesystem::path& file);

/// Writes a file so that a full disk, or a program that ends half way, leaves neither half of the new file nor destroys
/// the old one: the content goes to another file in the same folder, which is renamed at the end (see UnfinishedFile).
/// A file that is replaced must be writable, and the new one gets its permissions; if the path is a link, the file it
/// leads to is replaced. Pipes, devices and links that lead nowhere are written in place. Throws std::runtime_error,
/// "FILE: cannot be written: " and the system's reason.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

/// Writes a file piece by piece, for content too large for memory. The file gets its name in finish(); without finish()
/// nothing changes. All members throw as write_whole_file() does.
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
