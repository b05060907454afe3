// Atomic writes: the whole file or none of it.
#pragma once

#include <filesystem>
#include <string_view>

namespace rectilin {

/// Writes a file under another name and renames it at the end, so that a full disk or an end of the program in between
/// neither leaves half of it nor destroys what was there. Links, pipes and devices are written in place. Throws
/// std::runtime_error, "FILE: cannot be written", if that fails.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

}  // namespace rectilin
