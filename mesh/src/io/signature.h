// Files of another kind that go under a mesh's name.
#pragma once

#include <string_view>

namespace rectilin {

/// What bytes are by the way they begin, as the end of the sentence "the file is": "gzip-compressed", "a ZIP archive".
/// Empty for what may be a mesh. No OFF, OBJ or PLY file and no STL text begins like any of these; binary STL may, as
/// its first 80 bytes are free.
std::string_view foreign_kind(std::string_view bytes);

}  // namespace rectilin
