// Sums over the faces that matter in a small part of the sphere.
#pragma once

#include <vector>

#include "certify/generator_kernels.h"
#include "rectilin/optim/objective.h"

namespace rectilin::certification {

/// Vectors v_i whose great circles u . v_i = 0 may meet some region of the sphere, as a structure of arrays,
/// padded with zeros. The other faces have one sign all over the region: their part of h is linear.
class GeneratorList {
 public:
  GeneratorList() = default;
  explicit GeneratorList(const Generators& generators);

  std::size_t size() const { return size_; }

  /// sum sign(u . v_i) v_i
  Eigen::Vector3d cut(const Eigen::Vector3d& u) const;

  /// Puts into `active` the faces that do not have one sign at all corners of the triangle, and returns
  /// the signed sum of the others.
  Eigen::Vector3d split(const Triangle3& corners, GeneratorList& active) const;

  /// A copy that takes no more room than it needs.
  GeneratorList compact() const;

 private:
  GeneratorSpan span() const;
  void make_room(std::size_t size);

  std::vector<double> x_, y_, z_;
  std::size_t size_ = 0;
};

}  // namespace rectilin::certification
