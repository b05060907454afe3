// The silhouettes on the three planes of a frame: an objective like the projected area, but overlaps count once.
#pragma once

#include "rectilin/mesh/mesh.h"
#include "rectilin/optim/objective.h"
#include "rectilin/render/silhouette_area.h"

namespace rectilin::pose {

/// The summed area of a mesh's three silhouettes over its surface area, to be minimised over rotations. In [0, P/S];
/// for a closed convex mesh it is P/(2 S).
///
/// There are no cuts, for the silhouette's area is no convex function of the direction: nothing can be certified, and
/// the best value known is the best value found. Immutable and thread safe; the same bits for any number of threads.
class SummedSilhouette final : public Objective {
 public:
  /// Areas are known to within `tolerance`, relative (see render::Silhouette); values are the middles. Throws MeshError
  /// if the mesh has no area.
  explicit SummedSilhouette(const Mesh& mesh, double tolerance = 1e-6, std::string name = "mesh");

  std::string name() const override { return name_; }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override;

  /// What surely holds the exact sum.
  render::AreaInterval interval(const Rotation& rotation, double tolerance) const;

 private:
  render::Silhouette silhouette_;
  double area_, tolerance_;
  std::string name_;
};

}  // namespace rectilin::pose
