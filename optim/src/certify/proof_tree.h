// Records the course of a search, from which its certificate is written.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "certify/cell.h"
#include "certify/corner_game.h"
#include "rectilin/optim/certificate.h"

namespace rectilin::certification {

/// A tree that grows with the search; node 0 is the cube around the zone.
class ProofTree {
 public:
  /// Records that a node was halved. The lower half becomes the node returned, the upper half the one after it.
  std::uint32_t halve(std::uint32_t node, int axis);
  void set_outside(std::uint32_t node) { nodes_[node].kind = 'o'; }
  /// Records that a node was bounded by cuts: `weight` has the weights of the cuts in the bundles at that moment.
  void set_leaf(std::uint32_t node, const std::array<Cell::Bundle, 3>& bundles, const PerCut<double>& weight);

  /// Records that a node was bounded by floors, one for each axis, as SupportFloor proves them.
  void set_floor_leaf(std::uint32_t node, const std::array<double, 3>& floors);

  /// Sets the quadratic form that the floors refer to.
  void set_form(const Eigen::Matrix3d& form) { form_ = form; }

  /// Records the directions of the three cuts taken at a rotation, in the order of the cut table.
  void add_cuts(const Rotation& rotation);

  /// Sets the least bound of all leaves. Call it when every node is halved, a leaf or outside the zone.
  void set_bound(double bound) { bound_ = bound; }
  double bound() const { return bound_; }

  /// The certificate's tree, leaves and directions: everything except the result of the search.
  Certificate certificate() const;

 private:
  struct Node {
    char kind = '?';
    std::uint32_t next = 0;  // first child, leaf or floors
  };
  double bound_ = -std::numeric_limits<double>::infinity();
  std::vector<Node> nodes_ = {Node()};
  std::vector<Certificate::Leaf> leaves_;  // directions numbered as in the cut table
  std::vector<std::array<double, 3>> floors_;
  Eigen::Matrix3d form_ = Eigen::Matrix3d::Zero();
  std::vector<Eigen::Vector3d> directions_;
};

}  // namespace rectilin::certification
