// Small pictures of meshes, and sheets of them.
#pragma once

#include <string>
#include <vector>

#include "rectilin/measure/mesh.h"

namespace rectilin::figures {

enum class Up { kY, kZ };

/// The mesh from in front, the right and above, in parallel projection, as large as fits: a square
/// PNG file. Faces are shaded by their slope, creases and outlines drawn. Takes any soup of any
/// size; orientation does not matter.
std::string thumbnail(const Mesh& mesh, Up up);

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

}  // namespace rectilin::figures
