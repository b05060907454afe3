// The covered area of a cell of few edges, strip by strip.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "silhouette/multiplicity.h"

namespace rectilin::render {

/// From `y` upward the multiplicity on a cell's left side is greater by `jump`.
struct BorderStep {
  double y;
  std::int32_t jump;
};

/// A box of the picture: what is in it, and the multiplicity on its left side just above its lower left corner.
struct Cell {
  double left, right, low, high;
  std::int32_t multiplicity;
};

/// Where an edge is at the height y in its range, and how far off that may be: `kEdgeRounding` times the largest
/// coordinate. The share of the way along the edge has a relative error of at most 3 units of 2^-53.
double edge_x(const JumpEdge& edge, double y);
constexpr double kEdgeRounding = 0x1p-49;

/// Cuts a cell into strips at the ends of its edges and, where edges cross, at the crossings. In a strip in which no
/// two edges cross the covered length is linear in y.
class StripSweep {
 public:
  /// `scale` is the largest coordinate of the picture.
  explicit StripSweep(double scale) : rounding_(kEdgeRounding * scale) {}

  /// Adds the cell's covered area, and what it may be off by. The edges lie in the cell.
  void add(const Cell& cell, std::span<const JumpEdge> edges, std::span<const BorderStep> steps, CoveredArea& sum);

  /// How many areas of strips were added up.
  std::size_t strips() const { return strips_; }

 private:
  struct Run {  ///< an edge within a strip
    double low_x, high_x;
    std::int32_t jump;
  };
  void add_strip(const Cell& cell, double low, double high, std::int32_t multiplicity, std::vector<Run>& runs,
                 CoveredArea& sum);

  double rounding_;
  std::size_t strips_ = 0;
  std::vector<double> heights_;
  std::deque<std::vector<Run>> stack_;  ///< memory of the strips in work; stays in place as it grows
  std::size_t depth_ = 0;
};

}  // namespace rectilin::render
