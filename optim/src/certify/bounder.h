// From cuts to a cell's bound.
#pragma once

#include "certify/cell.h"
#include "certify/corner_game.h"

namespace rectilin::certification {

/// Bounds cells with the cuts in their bundles. Reads the table only: many threads may share one.
class Bounder {
 public:
  explicit Bounder(const CutTable& table) : table_(table) {}

  /// Raises the cell's bound, as far as `enough`, and returns the weights that prove it. If that is still not
  /// `enough`, finds the model's low point, ranks the edges by what halving them may gain, and moves useful
  /// cuts to the front.
  PerCut<double> raise(Cell& cell, double enough) const;

 private:
  const Eigen::Vector3d& slope(const Cell& cell, int k, int j) const { return table_[cell.bundles[k].cuts[j]]; }
  void describe(Cell& cell, const Corners& corners, const Strategies& strategies, const Array8& values) const;

  const CutTable& table_;
};

}  // namespace rectilin::certification
