// What a file's bytes are, in a few letters.
#pragma once

#include <optional>
#include <string>

namespace rectilin::search {

/// The file that holds a source: the archive of one of its members, the file itself, or nothing for a built-in shape.
std::string file_of(const std::string& source);

/// Hash (FNV-1a of 64 bits, by words of eight bytes) and size of a file. Guards against mistakes, not malice. Nothing
/// if the file cannot be read.
std::optional<std::string> file_digest(const std::string& file);

/// The digest of a source: that of its file, with a hash of the member's name for an archive; of a built-in shape, the
/// hash of its text. `digest` is that of file_of(source), which has many sources if it is an archive.
std::string source_digest(const std::string& source, const std::string& digest);

/// Why the file of a source cannot be read, in the words of load_mesh().
std::string why_no_digest(const std::string& source);

}  // namespace rectilin::search
