// Contact sheets: many small pictures on one sheet.
#pragma once

#include <string>
#include <vector>

namespace rectilin::report {

/// A picture (the content of a PNG file; may be empty) with a name and a value below it.
struct SheetCell {
  std::string png, name, value;
};

struct ContactSheet {
  std::string svg;
  int width;  ///< natural width in pixels
};

/// Arranges the cells row by row; the pictures are embedded in the SVG.
ContactSheet contact_sheet(const std::vector<SheetCell>& cells, int columns);

}  // namespace rectilin::report
