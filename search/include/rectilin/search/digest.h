// What a file's bytes are, in a few letters.
#pragma once

#include <string>

namespace rectilin::search {

/// The file that holds a source: the archive of one of its members, the file itself, or nothing for a built-in shape.
std::string file_of(const std::string& source);

/// Size and hash (FNV-1a of 64 bits, by words of eight bytes) of a source's file, with the member's name for an
/// archive; of a built-in shape, the hash of its text. Guards against mistakes, not malice. Throws std::runtime_error
/// if the file cannot be read.
std::string source_digest(const std::string& source);

}  // namespace rectilin::search
