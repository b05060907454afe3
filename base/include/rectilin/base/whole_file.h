// Files that are read in one piece, and written whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rectilin {

/// All bytes of a file, a pipe or a socket; a pipe is read to its end. Devices, which may have none, are refused.
/// Throws std::runtime_error, "FILE: " and the system's reason.
std::string read_whole_file(const std::filesystem::path& file);

/// Writes a file under another name in the same folder and renames it at the end (see UnfinishedFile), so that a full
/// disk or an end of the program in between neither leaves half of it nor destroys what was there. What it replaces
/// hands on its permissions and must be writable; a link stays, and the file it leads to is replaced. Pipes, devices
/// and links to nowhere are written in place. Throws std::runtime_error, "FILE: cannot be written: " and the system's
/// reason.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

}  // namespace rectilin
