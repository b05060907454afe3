#include "rectilin/report/contact_sheet.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "rectilin/base/printable.h"
#include "rectilin/report/html.h"

namespace rectilin::report {
namespace {

constexpr int kWidth = 140, kPicture = 132, kHeight = 174,
              kLine = 14;                 // sizes of a cell and of the picture in it, in pixels
constexpr std::size_t kNameColumns = 22;  // columns of text that a name has room for

/// Base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

/// The name on one line or, if it does not fit and has a comma, on two.
std::vector<std::string> lines(const std::string& name) {
  const std::size_t comma = name.find(", ");
  if (width(printable(name)) <= kNameColumns || comma == std::string::npos)
    return {shortened_to_end(name, kNameColumns)};
  return {shortened_to_end(name.substr(0, comma), kNameColumns),
          shortened_to_end(name.substr(comma + 2), kNameColumns)};
}

}  // namespace

ContactSheet contact_sheet(const std::vector<SheetCell>& cells, int columns) {
  const bool two_lines = std::ranges::any_of(cells, [](const SheetCell& c) { return lines(c.name).size() > 1; });
  const int cell_height = kHeight + (two_lines ? kLine : 0);
  const int rows = (static_cast<int>(cells.size()) + columns - 1) / columns;
  const int width = columns * kWidth, height = rows * cell_height;
  std::ostringstream svg;
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\" font-family=\"sans-serif\" font-size=\"11.5\" text-anchor=\"middle\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const SheetCell& cell = cells[i];
    const int x = static_cast<int>(i) % columns * kWidth, middle = x + kWidth / 2;
    int y = static_cast<int>(i) / columns * cell_height;
    if (!cell.png.empty())
      svg << "<image x=\"" << x + (kWidth - kPicture) / 2 << "\" y=\"" << y << "\" width=\"" << kPicture
          << "\" height=\"" << kPicture << "\" href=\"data:image/png;base64," << base64(cell.png) << "\"/>\n";
    y += kPicture;
    for (const std::string& line : lines(cell.name))
      svg << "<text x=\"" << middle << "\" y=\"" << (y += kLine) << "\" fill=\"#444\">" << html::escape(line)
          << "</text>\n";
    svg << "<text x=\"" << middle << "\" y=\"" << y + kLine + 2 << "\" font-size=\"13\">" << html::escape(cell.value)
        << "</text>\n";
  }
  svg << "</svg>\n";
  return {svg.str(), width};
}

}  // namespace rectilin::report
