// Pieces of a web page that opens from disk.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rectilin::report::html {

/// Text as HTML or SVG shows it, in one line: printable (see printable()), with entities for what has a meaning.
std::string escape(std::string_view text);
/// The same for text of several lines.
std::string escape_lines(std::string_view text);

/// A table that scrolls if it is wider than the screen. Cells are HTML; the first column is text, the others are
/// numbers.
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
/// Hidden behind a line to click on, but printed.
std::string details(const std::string& summary, const std::string& html);
std::string link(const std::string& target, const std::string& text);

/// A picture with a caption, at most a little larger than `width` pixels. Wide ones scroll on small screens instead
/// of shrinking.
std::string picture(const std::string& svg, const std::string& caption, const std::string& more, int width);
/// Things side by side where there is room.
std::string side_by_side(const std::string& html);

/// The whole page with its style, which is all inside.
std::string page(const std::string& title, const std::string& body);

}  // namespace rectilin::report::html
