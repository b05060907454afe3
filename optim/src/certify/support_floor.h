// Lower bounds of h where the axes of a box's frames point to, for objectives that are nearly constant.
#pragma once

#include <tbb/concurrent_vector.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "certify/generator_list.h"
#include "certify/sweep.h"

namespace rectilin::certification {

/// For a nearly round body every cut is tangent to something that curves away from it, and cells would have to shrink
/// with the square root of the gap in all three dimensions. But h lives on the sphere, which has two dimensions, and is
/// nearly constant there. As a rule the least values of h on what the three axes sweep add up to enough, for boxes as
/// wide as a tenth of a radian.
///
/// Where h also varies smoothly, as for an ellipsoid, most of its variation is a quadratic form u . F u. The sum of the
/// form over three orthogonal axes is its trace, whichever axes they are. So what is bounded here is h(u) - u . F u;
/// its lower bounds are called floors.
///
/// One subdivision of the sphere into triangles serves all axes of all boxes (papers/certificate.md, lemma 3). It is
/// refined where a box needs it. Between two calls of update() the answers do not depend on the order of the questions,
/// so results are the same for any number of threads.
class SupportFloor {
 public:
  /// Bounds are lowered by `margin` in addition to what rounding demands. Once `stop` returns true nothing more
  /// is proved.
  SupportFloor(const Generators& generators, double margin, std::function<bool()> stop);
  ~SupportFloor();

  /// Three floors of h(u) - u . F u on the sweeps, one for each axis, that add up to `enough` less the trace of F.
  /// Nothing if there are none, or if finding them costs too much. Thread safe.
  std::optional<std::array<double, 3>> prove(const std::array<Sweep, 3>& sweeps, double enough) const;

  /// Passes on what was learnt about parts of triangles to the triangles that contain them. Must not be called
  /// during prove().
  void update();

  const Eigen::Matrix3d& form() const { return form_; }

  /// Number of triangles looked at so far.
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
  int kept_levels_;  // levels whose triangles keep lists of generators
  bool full_ = false;
  std::unique_ptr<Block> octants_;
  mutable tbb::concurrent_vector<const Node*> blocks_;  // the triangles that were divided
  std::size_t known_ = 0;                               // how many of them update() has seen
};

}  // namespace rectilin::certification
