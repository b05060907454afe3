// What is looked at in a 3MF file before a library is.
#pragma once

#include <string>
#include <string_view>

namespace rectilin {

/// Throws MeshError if the zip unpacks to too much, or if components of components repeat objects too often: lib3mf
/// goes through every repetition when it reads, so that a file of a kilobyte would take it years.
void check_3mf_parts(std::string_view zip, const std::string& name);

}  // namespace rectilin
