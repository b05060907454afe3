// A proof of a lower bound, in a form that can be checked without the search that found it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rectilin/base/json_fwd.h"
#include "rectilin/base/rotation.h"

namespace rectilin {

/// The cube |rho_i| <= sqrt(2)-1 of Rodrigues vectors, halved again and again across the middle until a mixture of
/// cuts bounds each part, or the least values, where its axes point to, of h less a quadratic form. A cut is given by
/// the direction it is taken in alone: who checks it sums over the faces. So are floors by their values.
struct Certificate {
  /// One letter a node, every node before its parts, the lower half before the upper: 'x', 'y', 'z' halve
  /// that axis; 'l' is the next leaf; 'h' takes the next floors; 'o' lies outside the zone |rho|_1 <= 1. "f" alone
  /// stands for the general bound: no value is below S/S = 1.
  std::string tree;

  struct Term {
    std::uint32_t direction;  ///< index into `directions`
    double weight;            ///< positive; those of an axis add up to 1, but for rounding
  };
  struct Leaf {
    std::vector<Term> axes[3];
  };
  std::vector<Leaf> leaves;
  /// Of h(r_k) - r_k . F r_k, k = 0, 1, 2, on the box; with the trace of F they add up to `lower` or more.
  std::vector<std::array<double, 3>> floors;
  Eigen::Matrix3d form = Eigen::Matrix3d::Zero();  ///< F: symmetric
  std::vector<Eigen::Vector3d> directions;         ///< unit vectors in the mesh's coordinates

  Rotation rotation;  ///< the incumbent
  double value = 0;   ///< the objective there
  double lower = 0;   ///< proved: no rotation has a smaller value
};

/// The certificate as JSON: format, version, "mesh" (which says what it is about), and the fields above.
Json to_json(const Certificate& certificate, const std::string& mesh);

}  // namespace rectilin
