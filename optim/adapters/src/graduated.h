// Graduated smoothing: minimise a heavily rounded-off objective, then a less rounded one from where that ended, and
// so on.
#pragma once

#include <cmath>

#include "rectilin/base/parameters.h"

namespace rectilin {

/// The widths of the smooth surrogate: from `width` down to `narrow` in equal ratios (Blake and Zisserman 1987 call the
/// idea graduated non-convexity).
struct Graduation {
  double width = 0.1;
  double narrow = 1e-6;
  int rounds = 6;

  double at(int round) const {
    return rounds == 1 ? narrow : width * std::pow(narrow / width, static_cast<double>(round) / (rounds - 1));
  }

  void bind(Parameters& table) {
    table.real("width", width, 1e-12, 10, "width of the smooth surrogate in the first round, radians")
        .real("narrow", narrow, 1e-12, 10, "width in the last round")
        .integer("rounds", rounds, 1, 1000, "number of rounds; each begins where the one before it ended");
  }
};

}  // namespace rectilin
