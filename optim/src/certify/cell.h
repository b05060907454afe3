// A cell of the search: a box and what is known about it.
#pragma once

#include <cstdint>
#include <limits>

#include "certify/box.h"

namespace rectilin::certification {

struct Cell {
  static constexpr int kMaxBundle = 8;

  /// The cuts in use for one axis, as indices into the table; the newest or most useful first.
  struct Bundle {
    std::array<std::uint32_t, kMaxBundle> cuts;
    int size = 0;

    /// Puts a cut in front; if there are more than `capacity` the last one is dropped.
    void add(std::uint32_t cut, int capacity) {
      size = std::min(size + 1, capacity);
      std::copy_backward(cuts.begin(), cuts.begin() + size - 1, cuts.begin() + size);
      cuts[0] = cut;
    }
  };

  Box box;
  double bound = 0;  ///< the objective is nowhere less on the box, up to rounding
  std::array<Bundle, 3> bundles;

  /// The model of the objective is the sum over the axes of the largest of their cuts. This is where the sieve, or the
  /// mixture of the corners, puts the minimum of the model, and the model's value there: minus infinity until the cell
  /// has been bounded.
  Eigen::Vector3d low_point = Eigen::Vector3d::Zero();
  double model = -std::numeric_limits<double>::infinity();

  Eigen::Vector3f spread = Eigen::Vector3f::Ones();  ///< what halving each edge may gain
  std::uint32_t node = 0;                            ///< its node in the proof's tree
};

}  // namespace rectilin::certification
