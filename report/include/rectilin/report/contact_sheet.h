// Sheets of small pictures.
#pragma once

#include <string>
#include <vector>

namespace rectilin::report {

/// A picture (a PNG file, or none) with its name and its value below.
struct SheetCell {
  std::string png, name, value;
};

struct ContactSheet {
  std::string svg;
  int width;  ///< natural, in pixels
};

/// The cells row by row, the pictures inside the SVG.
ContactSheet contact_sheet(const std::vector<SheetCell>& cells, int columns);

}  // namespace rectilin::report
