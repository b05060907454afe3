// The record of a search, from which a certificate is written.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "certify/cell.h"
#include "certify/corner_game.h"
#include "rectilin/optim/certificate.h"

namespace rectilin::certification {

/// Grows with the search: node 0 is the zone's cube.
class ProofTree {
 public:
  /// Halves a node; the lower half becomes the node returned, the upper half the one after it.
  std::uint32_t halve(std::uint32_t node, int axis);
  void set_outside(std::uint32_t node) { nodes_[node].kind = 'o'; }
  /// `weight` are those of the cuts in the cell's bundles, as they were when it was bounded.
  void set_leaf(std::uint32_t node, const std::array<Cell::Bundle, 3>& bundles, const PerCut<double>& weight);

  /// With floors, one an axis, as SupportFloor proves them.
  void set_floor_leaf(std::uint32_t node, const std::array<double, 3>& floors);

  /// The quadratic form of the floors.
  void set_form(const Eigen::Matrix3d& form) { form_ = form; }

  /// Remembers the directions of the three cuts that a rotation gave, in the order of the cut table.
  void add_cuts(const Rotation& rotation);

  /// The least bound of all leaves; to be set when every node is halved, a leaf or outside.
  void set_bound(double bound) { bound_ = bound; }
  double bound() const { return bound_; }

  /// Tree, leaves and the directions they use; everything but the result of the search.
  Certificate certificate() const;

 private:
  struct Node {
    char kind = '?';
    std::uint32_t next = 0;  // first child, leaf or floors
  };
  double bound_ = -std::numeric_limits<double>::infinity();
  std::vector<Node> nodes_ = {Node()};
  std::vector<Certificate::Leaf> leaves_;  // directions counted as in the cut table
  std::vector<std::array<double, 3>> floors_;
  Eigen::Matrix3d form_ = Eigen::Matrix3d::Zero();
  std::vector<Eigen::Vector3d> directions_;
};

}  // namespace rectilin::certification
