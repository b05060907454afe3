// Planes of mirror symmetry: how good one is, and where the good ones are.
#pragma once

#include <vector>

#include "near_field.h"

namespace rectilin::pose {

/// The plane normal . x = offset, in the coordinates of a Surface.
struct MirrorPlane {
  Vector3 normal;
  double offset = 0;
  double defect = 1;  ///< 0: the surface is its own mirror image; 1: nothing of it is
};

/// Judges planes by reflecting samples of the surface and looking how near the surface they come.
/// defect = 1 - mean(exp(-d^2 / (2 (.09 r)^2)) (n' . n)^2), d the distance of a reflected point from the surface, n'
/// its reflected normal, n that of the surface there, and r the root mean square radius. The width lets parts that
/// nearly match count, and what is further off counts as absent, however far it is: a mirror plane of most of an object
/// is still one.
class MirrorDefect {
 public:
  /// `hull` is the surface's convex hull, or anything else with the same extent.
  MirrorDefect(const Surface& surface, const Mesh& hull);

  double of(const Vector3& normal, double offset) const { return measure(fine_, normal, offset); }
  /// With fewer samples.
  double roughly(const Vector3& normal, double offset) const { return measure(coarse_, normal, offset); }

  /// The better of the planes through the centre of mass and through the middle of the extent.
  MirrorPlane through_middle(const Vector3& normal) const;
  double middle_of_extent(const Vector3& normal) const;

  /// Moves a plane nearby to where reflected samples lie in the planes of the faces they come to: a few rounds of least
  /// squares in which near and parallel faces count. For a mesh that is its own mirror image up to rounding it ends at
  /// the exact plane.
  MirrorPlane polished(MirrorPlane plane) const;

  double width() const { return width_; }

 private:
  double measure(const Samples& samples, const Vector3& normal, double offset) const;

  double width_;
  NearField field_;
  Samples fine_, coarse_;
  std::vector<Vector3> outline_;  // corners of the hull
};

/// The local minima of the defect, best first, no two within 5 degrees; `count` at most. Every plane whose normal is in
/// a scan of the hemisphere at 4 degrees is looked at, the best of them are moved in tilt and offset to a minimum.
std::vector<MirrorPlane> mirror_planes(const MirrorDefect& defect, std::size_t count);

}  // namespace rectilin::pose
