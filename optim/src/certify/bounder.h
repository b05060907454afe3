// Computes a cell's bound from its cuts.
#pragma once

#include "certify/cell.h"
#include "certify/corner_game.h"

namespace rectilin::certification {

/// Bounds cells with the cuts in their bundles. It only reads the table, so threads can share one.
class Bounder {
 public:
  explicit Bounder(const CutTable& table) : table_(table) {}

  /// Raises the cell's bound as far as possible, but no further than `enough`, and returns the weights that prove it.
  /// If the bound is still below `enough`, it also finds the minimum of the model, ranks the edges by what halving them
  /// may gain, and moves useful cuts to the front of the bundles.
  PerCut<double> raise(Cell& cell, double enough) const;

 private:
  const Eigen::Vector3d& slope(const Cell& cell, int k, int j) const { return table_[cell.bundles[k].cuts[j]]; }
  void describe(Cell& cell, const Corners& corners, const Strategies& strategies, const Array8& values) const;

  const CutTable& table_;
};

}  // namespace rectilin::certification
