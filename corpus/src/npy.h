// NumPy's file format (NumPy Enhancement Proposal 1, 2007) for tables.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace rectilin::corpus {

/// The header of a file that holds a table. `fields` are written as NumPy writes them: "('area', '<f8')".
std::string npy_header(std::span<const std::string> fields, std::size_t rows);

/// Appends the text, filled up with zeros to a field of `size` bytes.
void append_bytes(std::string& out, std::string_view text, std::size_t size);

}  // namespace rectilin::corpus
