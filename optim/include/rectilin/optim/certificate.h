// A proof of a lower bound, written so that a program that shares no code with the search can check it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "rectilin/base/json_fwd.h"
#include "rectilin/base/rotation.h"

namespace rectilin {

/// The cube |rho_i| <= sqrt(2)-1 of Rodrigues vectors is halved again and again, until each part has a bound of its
/// own: either a mixture of cuts, or floors, that is lower bounds of h less a quadratic form where the three axes point
/// to. A cut is stated only by the direction that it is taken in; whoever checks it computes its sum over the faces
/// anew. Floors are stated by their values and shown anew, too.
struct Certificate {
  /// The halvings as text, one letter for each node; a node stands before its two halves, and the lower half before the
  /// upper one. 'x', 'y' and 'z' halve along that axis; 'l' is the next leaf with cuts; 'h' is a leaf with the next
  /// floors; 'o' lies outside the zone |rho|_1 <= 1. The text "f" alone stands for the general bound: no value is below
  /// S/S = 1.
  std::string tree;

  struct Term {
    std::uint32_t direction;  ///< index into `directions`
    double weight;            ///< positive; the weights of an axis add up to 1, up to rounding
  };
  struct Leaf {
    std::vector<Term> axes[3];
  };
  std::vector<Leaf> leaves;
  /// Floors of h(r_k) - r_k . F r_k, k = 0, 1, 2, on the box; together with the trace of F they add up to `lower`
  /// or more.
  std::vector<std::array<double, 3>> floors;
  Eigen::Matrix3d form = Eigen::Matrix3d::Zero();  ///< F, symmetric
  std::vector<Eigen::Vector3d> directions;         ///< unit vectors in the mesh's coordinates

  Rotation rotation;  ///< the incumbent
  double value = 0;   ///< the objective there
  double lower = 0;   ///< proved: no rotation has a smaller value
};

/// The certificate as JSON: `format`, `version`, `mesh` (which identifies the mesh), and the fields above.
Json to_json(const Certificate& certificate, const std::string& mesh);

}  // namespace rectilin
