// Which build of the library this is.
#pragma once

namespace rectilin {

const char* version();     ///< such as "0.3.0"
const char* compiler();    ///< the compiler that built it, such as "GNU 12.2.0"
const char* build_type();  ///< CMake's build type, such as "Release"

}  // namespace rectilin
