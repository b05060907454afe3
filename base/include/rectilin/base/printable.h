// Text from outside (names of files, labels, messages) made fit to be shown: on a terminal, in SVG, HTML, CSV and in
// gnuplot's files. All that is shown of such text goes through here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rectilin {

/// The text as valid UTF-8 without anything that is not seen or that acts on what shows it. Control characters become
/// `\n`, `\r`, `\t` or `\x1B`; bytes that are not UTF-8 (RFC 3629) `\xFF`; the controls U+0080 to U+009F, line and
/// paragraph separators, marks that change the direction of writing (Unicode Standard Annex 9), and what XML 1.0
/// forbids, `\u{202E}`. Anything else stays as it is, so that usual text comes back unchanged; applied twice, it does
/// no more than once. The result has one line.
std::string printable(std::string_view text);

/// Whether printable() would leave the text as it is.
bool is_printable(std::string_view text);

/// How many columns of a terminal printable text takes: none for combining marks, two for wide characters (those of
/// East Asian scripts and pictographs, Unicode Standard Annex 11), one for any other. Tables are aligned by it.
std::size_t width(std::string_view printable_text);

/// At most `columns` wide, at least 5: text that is wider loses its middle, in whole characters, to "..". Names keep
/// their ends that way, where they mostly differ. Makes the text printable first.
std::string shortened(std::string_view text, std::size_t columns);

/// The same for text that keeps nothing but its end.
std::string shortened_to_end(std::string_view text, std::size_t columns);

}  // namespace rectilin
