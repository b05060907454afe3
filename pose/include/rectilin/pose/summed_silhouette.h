// The silhouettes on the three planes of a frame: an objective like the projected area, but overlaps count once.
#pragma once

#include "rectilin/mesh/mesh.h"
#include "rectilin/optim/objective.h"
#include "rectilin/render/camera.h"

namespace rectilin::pose {

/// The summed area of the three silhouettes of a mesh, over its surface area, to be minimised over rotations. The areas
/// are pixel counts of pictures of `size` pixels in which the ball about the surface's centre of mass, through the
/// furthest corner, just fits (paper, section 6): so values are steps, and off by one or two percent for thin parts.
/// There are no cuts, so nothing can be certified. Immutable and thread safe; the same bits for any number of threads.
class SummedSilhouette final : public Objective {
 public:
  /// Throws MeshError if the mesh has no area.
  explicit SummedSilhouette(const Mesh& mesh, int size = 256, std::string name = "mesh");

  std::string name() const override { return name_; }
  void values(std::span<const Rotation> rotations, std::span<double> values) const override;
  double value(const Rotation& rotation) const;

 private:
  Mesh mesh_;  // of size one, centred
  render::Ball ball_;
  int size_;
  double per_pixel_;  // area of a pixel over the surface's
  std::string name_;
};

}  // namespace rectilin::pose
