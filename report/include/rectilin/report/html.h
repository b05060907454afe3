// Pieces of web pages that open from disk, without a server.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rectilin::report::html {

/// Makes text safe for HTML and SVG: one printable line (see printable()), with entities for characters that have a
/// meaning there.
std::string escape(std::string_view text);
/// The same for text of several lines, which stay.
std::string escape_lines(std::string_view text);

/// A table that scrolls sideways if it is wider than the screen. Cells are HTML; the first column is text, the others
/// are numbers.
class Table {
 public:
  explicit Table(const std::vector<std::string>& header);
  Table& row(const std::vector<std::string>& cells);
  std::string text() const;

 private:
  std::string rows_;
};

std::string heading(const std::string& text);
std::string paragraph(const std::string& html);
/// HTML that is hidden until the summary is clicked, but always printed.
std::string details(const std::string& summary, const std::string& html);
std::string link(const std::string& target, const std::string& text);

/// A picture with a caption, shown at most a little larger than `width` pixels. On small screens wide pictures scroll
/// instead of shrinking.
std::string picture(const std::string& svg, const std::string& caption, const std::string& more, int width);
/// Puts things side by side where there is room.
std::string side_by_side(const std::string& html);

/// The whole page, which contains its style and needs no other files for it.
std::string page(const std::string& title, const std::string& body);

}  // namespace rectilin::report::html
