// Makes text from outside (file names, labels, error messages) safe to show: on a terminal, in SVG, HTML, CSV and in
// gnuplot's files. Everything shown that comes from outside goes through here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rectilin {

/// The text as one line of valid UTF-8, without invisible characters and without any that would act on what displays
/// it. Control characters become `\n`, `\r`, `\t` or `\x1B`; bytes that are not UTF-8 (RFC 3629) become `\xFF`. The
/// controls U+0080 to U+009F, line and paragraph separators, marks that change the direction of writing (Unicode
/// Standard Annex 9) and whatever XML 1.0 forbids become `\u{202E}`. Everything else stays, so ordinary text comes back
/// unchanged, and applying the function twice is the same as once.
std::string printable(std::string_view text);

/// Whether printable() would leave the text as it is.
bool is_printable(std::string_view text);

/// How many columns of a terminal a printable text takes: none for combining marks, two for wide characters (those of
/// East Asian scripts and pictographs, Unicode Standard Annex 11), one for every other. Tables are aligned with it.
std::size_t width(std::string_view printable_text);

/// Shortens text to at most `columns` columns (5 or more) by replacing its middle, in whole characters, by "..": names
/// mostly differ at their ends. Makes the text printable first.
std::string shortened(std::string_view text, std::size_t columns);

/// Likewise, but keeps only the end of the text.
std::string shortened_to_end(std::string_view text, std::size_t columns);

}  // namespace rectilin
