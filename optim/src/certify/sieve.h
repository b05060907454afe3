// Settles small parts of a box with the cuts that are known, without a linear programme.
#pragma once

#include <array>
#include <optional>

#include "certify/cell.h"
#include "certify/cut_table.h"
#include "certify/kink_ball.h"

namespace rectilin::certification {

/// What is left of half a box.
struct Rest {
  Box box;
  double bound;               ///< the objective is nowhere less on the box, up to rounding
  double value;               ///< the least value that the cuts have at the middle of a part
  Eigen::Vector3d low_point;  ///< this middle
};

/// What is left of the two halves of a box; nothing, if every part is settled.
using Halves = std::array<std::optional<Rest>, 2>;

/// Halves a cell's box across an axis, and shrinks each half to the smallest box that holds its parts (octants, their
/// octants, and theirs) that cannot be settled. A part is settled if it is outside the zone, in a ball, or if three
/// cuts prove `enough` on it: for each axis the greatest that is known at the part's middle, as far as rivals.h tells.
/// A part takes some ten nanoseconds, a linear programme for the best mixture a hundred times as long, and most parts
/// are so small that they need none.
Halves sift(const Cell& cell, int axis, const CutTable& table, const Balls& balls, double enough);

}  // namespace rectilin::certification
