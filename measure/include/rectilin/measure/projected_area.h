// The objective: the sum of projected areas on the planes of a frame, P(R)/S.
//
// A face with area vector v (its length the area, its direction the normal) has on the plane orthogonal to a unit
// vector u the projected area |u . v|. Summed over all faces that is
//
//     h(u) = |u . v1| + ... + |u . vN|,
//
// and on the three planes of a frame with axes r1, r2, r3 (eqs. 1, 2 and 7)
//
//     P(R) = h(r1) + h(r2) + h(r3).
//
// P is S when every face is orthogonal to an axis, and at most sqrt(3) S (eq. 12). The least ratio P/S over all
// rotations gives the rectilinearity, R(M) = 3 (max S/P - 2/3) (eq. 27).
//
//     const ProjectedArea objective(area_vectors(make_shape(Spec::parse("box"))));
//     objective.value(Rotation());                                       // 1: a box along the axes
//     objective.value(rotation_from_euler(0, 0, std::numbers::pi / 4));  // 1 + (sqrt(2) - 1) 2/3: turned by 45 degrees
//     rectilinearity(1.0);                                               // 1
//
// A tree sums a million vectors in microseconds (direction_tree.h); a flat sum goes over all of them with vector
// instructions (flat_sum.h); in between, runs of sixteen are summed at once where they can be (run_sum.h). The number
// of vectors decides which of them is used.
#pragma once

#include <mutex>
#include <optional>

#include "rectilin/measure/area_vectors.h"
#include "rectilin/measure/direction_tree.h"
#include "rectilin/measure/flat_sum.h"
#include "rectilin/measure/run_sum.h"
#include "rectilin/optim/objective.h"

namespace rectilin {

/// R(M) from the least ratio P/S (eq. 27): 3 (S/P - 2/3). Ratios lie in [1, sqrt(3)] (eq. 12).
inline double rectilinearity(double ratio) { return 3 / ratio - 2; }

/// How the sums over the area vectors are computed. All ways are exact up to rounding.
enum class SumMethod {
  kAuto,  ///< DirectionTree or RunSum if worthwhile(), otherwise FlatSum; if both, the tree for values, runs for cuts
  kFlat,  ///< FlatSum
  kTree,  ///< DirectionTree
};

/// P(R)/S of a mesh, to be minimised over rotations; its merit is the rectilinearity. P(R) = h(r1) + h(r2) + h(r3) with
/// h(u) = sum_i |u . v_i| over the area vectors (eqs. 1, 2, 7). Immutable and thread safe, with the same bits for any
/// number of threads and any division into batches. `precision` applies to the flat sum only; the tree, the flat sum
/// inside it and the runs, which are not used in single precision, use double precision.
class ProjectedArea final : public Objective {
 public:
  explicit ProjectedArea(AreaVectors vectors, std::string name = "mesh", SumMethod method = SumMethod::kAuto,
                         Precision precision = Precision::kDouble);
  ProjectedArea(const ProjectedArea&) = delete;  // the sums refer to the vectors by address
  ProjectedArea& operator=(const ProjectedArea&) = delete;

  std::string name() const override { return name_; }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override;
  bool has_cuts() const override { return true; }
  void cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) const override;
  CutBounds cut_bounds() const override;
  Generators generators() const override;
  bool has_smooth() const override { return true; }
  SmoothValue smooth(const Rotation& rotation, double width) const override;
  bool has_turns() const override { return true; }
  BestTurn best_turn(const Rotation& rotation, int k) const override;
  double merit(double value) const override { return rectilinearity(value); }

  const AreaVectors& vectors() const { return vectors_; }

 private:
  const DirectionTree& tree() const;
  const RunSum& runs() const;

  AreaVectors vectors_;
  FlatSum flat_;
  bool use_tree_, use_runs_;
  mutable std::once_flag tree_once_, runs_once_;
  mutable std::optional<DirectionTree> tree_;  // both are made when first asked for
  mutable std::optional<RunSum> runs_;
  std::string name_;
};

}  // namespace rectilin
