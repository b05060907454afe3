// Computes a cell's bound from cuts.
#pragma once

#include "certify/cell.h"
#include "certify/corner_game.h"
#include "certify/cut_table.h"

namespace rectilin::certification {

/// Bounds cells with the cuts in their bundles and with others that are known near by. It only reads the table, so
/// threads can share one.
class Bounder {
 public:
  /// `capacity` is the greatest size of a bundle.
  Bounder(const CutTable& table, int capacity) : table_(table), capacity_(capacity) {}

  struct Bound {
    PerCut<double> weight;  ///< of the cuts in the bundles
    double value;           ///< what the mixture of cuts with these weights proves on the cell's box
  };

  /// The best mixture of the cuts in the bundles, or one that proves `enough`.
  Bound mix(const Cell& cell, double enough) const;

  /// Raises the cell's bound as far as possible, but no further than `enough`. Cuts that other cells have asked for are
  /// put into the bundles if they help. Returns the weights of the last mixture: if the bound is `enough`, they prove
  /// it. If it is still below, this also finds the minimum of the model, ranks the edges by what halving them may gain,
  /// and moves useful cuts to the front of the bundles, so that the weights mean nothing any more.
  PerCut<double> raise(Cell& cell, double enough) const;

 private:
  /// Strategies for a box, and the form that they prove.
  struct Mixture {
    Strategies strategies;
    Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
    Array8 values = Array8::Zero();  // of the form, at the corners
    double bound = 0;
  };

  Eigen::Vector3d slope(const Cell& cell, int k, int j) const { return table_[cell.bundles[k].cuts[j]]; }
  double greatest(const Cell& cell, int k, const Eigen::Vector3d& u) const;
  Mixture mixture(const Cell& cell, const Corners& corners, double enough) const;
  bool borrow(Cell& cell, const Corners& corners, const Mixture& mixture, double enough) const;
  void describe(Cell& cell, const Corners& corners, const Mixture& mixture) const;
  static void put_useful_first(Cell& cell, const Strategies& strategies);

  const CutTable& table_;
  int capacity_;
};

}  // namespace rectilin::certification
