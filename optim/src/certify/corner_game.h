// The best mixture of cuts for a box: a small linear programme.
#pragma once

#include <array>

#include "certify/box.h"

namespace rectilin::certification {

/// Most cuts of one axis in a game.
inline constexpr int kMaxCuts = 9;

template <class T>
using PerCut = std::array<std::array<T, kMaxCuts>, 3>;

/// A game of two players: one mixes the cuts of each axis (three mixtures), the other mixes the box's corners; the
/// payoff is the sum over the axes of the cut's value at the corner. Every axis has at least one cut.
struct CornerGame {
  std::array<int, 3> size = {};
  PerCut<Array8> payoff;

  void add(int axis, const Array8& values) { payoff[axis][size[axis]++] = values; }
};

struct Strategies {
  PerCut<double> weight = {};  ///< of the cuts: nonnegative, sum 1 on each axis to rounding
  Array8 corner;               ///< the other player's mixture
  double value = 0;            ///< the least payoff over the corners for these weights
};

/// Strategies that are optimal, or guarantee the first player `enough`. Any weights make a valid bound, so nothing
/// depends on how well this does; rounding costs quality only.
Strategies solve(const CornerGame& game, double enough);

}  // namespace rectilin::certification
