// How low h gets where the axes of a box's frames point to, for objectives that are nearly constant.
#pragma once

#include <tbb/concurrent_vector.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "certify/generator_list.h"
#include "certify/sweep.h"

namespace rectilin::certification {

/// On a nearly round body every cut is tangent to a body that curves away from it, and cells must shrink with the
/// square root of the gap in all three dimensions. But h lives on the sphere, which has two, and is nearly constant
/// there: as a rule the least values of h on what the three axes sweep add up to enough, for boxes a tenth of a radian
/// wide.
///
/// Where h also varies smoothly, as on an ellipsoid, most of that is a quadratic form u . F u; the sum of the form over
/// three orthogonal axes is its trace, whichever they are. So floors are those of h(u) - u . F u.
///
/// One subdivision of the sphere into triangles serves all axes of all boxes (papers/certificate.md, lemma 3). It is
/// refined where a box asks for it. Between two calls of update() the answers do not depend on their order, so
/// results are the same for any number of threads.
class SupportFloor {
 public:
  /// Bounds are lowered by `margin` more than rounding asks for. Once `stop` returns true, nothing is proved any more.
  SupportFloor(const Generators& generators, double margin, std::function<bool()> stop);
  ~SupportFloor();

  /// Numbers, one an axis, that h(u) - u . F u does not fall below on the sweeps, and that add up to `enough` less the
  /// trace of F; nothing if there are none, or at a price that is not worth it. Thread safe.
  std::optional<std::array<double, 3>> prove(const std::array<Sweep, 3>& sweeps, double enough) const;

  /// Makes what was learnt of parts known to the triangles they are part of. Not to be called during prove().
  void update();

  const Eigen::Matrix3d& form() const { return form_; }

  /// Triangles that were looked at so far.
  std::size_t triangles() const { return 4 * blocks_.size(); }

 private:
  struct Node;
  using Block = std::array<Node, 4>;
  class Front;

  const GeneratorList& faces_over(const Node& node, Eigen::Vector3d& settled) const;
  const Block* parts_of(const Node& node) const;

  Eigen::Matrix3d form_;
  double rounding_;
  std::function<bool()> stop_;
  int kept_levels_;  // of lists of faces
  bool full_ = false;
  std::unique_ptr<Block> octants_;
  mutable tbb::concurrent_vector<const Node*> blocks_;  // what was divided
  std::size_t known_ = 0;                               // how many of them update() has seen
};

}  // namespace rectilin::certification
