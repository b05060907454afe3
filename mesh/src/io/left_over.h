// What stands behind the last thing that a reader understands.
#pragma once

#include <string>
#include <string_view>

#include "io/text.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin {

/// A text without the NUL and Ctrl-Z characters that some systems put at the end, which are reported as padding.
std::string_view without_padding(std::string_view text, MeshReport& report);

/// Reports what follows the line a reader is in, if there is more than comments and white space.
void report_left_over(LineReader& text, MeshReport& report);

/// Reports bytes behind binary data, which begin at a place in the file: as padding if they are but NUL or white space,
/// else as left over.
void report_left_over(std::string_view bytes, std::size_t place, MeshReport& report);

/// Whether bytes are all NUL, Ctrl-Z or white space.
bool is_padding(std::string_view bytes);

}  // namespace rectilin
