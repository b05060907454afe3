// The best mixture of cuts for a box, found by solving a small linear programme.
#pragma once

#include <array>

#include "certify/box.h"

namespace rectilin::certification {

/// The largest number of cuts of one axis in a game.
inline constexpr int kMaxCuts = 9;

template <class T>
using PerCut = std::array<std::array<T, kMaxCuts>, 3>;

/// A game of two players: one mixes the cuts of each axis (three mixtures), the other mixes the corners of the box. The
/// payoff is the sum over the axes of the cut's value at the corner. Every axis has at least one cut.
struct CornerGame {
  std::array<int, 3> size = {};
  PerCut<Array8> payoff;

  void add(int axis, const Array8& values) { payoff[axis][size[axis]++] = values; }
};

struct Strategies {
  PerCut<double> weight = {};  ///< weights of the cuts: nonnegative, adding up to 1 on each axis up to rounding
  Array8 corner;               ///< the other player's mixture
  double value = 0;            ///< the least payoff over the corners for these weights
};

/// Strategies that are optimal, or that guarantee the first player `enough`. Any weights make a valid bound, so no
/// proof depends on how well this does: rounding only makes bounds weaker.
Strategies solve(const CornerGame& game, double enough);

}  // namespace rectilin::certification
