// A cell of the search: a box and what is known of it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "certify/box.h"

namespace rectilin::certification {

/// Rows of all cuts taken, in the order they were. A row serves any axis: it is a minorant of h everywhere.
using CutTable = std::vector<Eigen::Vector3d>;

struct Cell {
  static constexpr int kMaxBundle = 8;

  /// The cuts an axis has in use, as indices into the table, latest or most useful first.
  struct Bundle {
    std::array<std::uint32_t, kMaxBundle> cuts;
    int size = 0;

    /// Puts a cut in front; of more than `capacity` the last is dropped.
    void add(std::uint32_t cut, int capacity) {
      size = std::min(size + 1, capacity);
      std::copy_backward(cuts.begin(), cuts.begin() + size - 1, cuts.begin() + size);
      cuts[0] = cut;
    }
  };

  Box box;
  double bound = 0;  ///< the objective is nowhere less on the box, but for rounding
  std::array<Bundle, 3> bundles;

  /// The model is the sum over the axes of the greatest of their minorants. Where the corners' mixture would put
  /// the minimum of the model, and its value there: minus infinity until the cell has been bounded.
  Eigen::Vector3d low_point = Eigen::Vector3d::Zero();
  double model = -std::numeric_limits<double>::infinity();

  Eigen::Vector3f spread = Eigen::Vector3f::Ones();  ///< loss that halving each edge may recover
  int retries = 0;                                   ///< times it went back to the heap with new cuts
  std::uint32_t node = 0;                            ///< place in the certificate's tree
};

}  // namespace rectilin::certification
