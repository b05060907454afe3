// From a frame, which is open modulo 24 rotations, to axes with an order and directions.
#pragma once

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// What is resolved (paper, section 7.1).
enum class AxisRule {
  /// Nothing: of the 24 rotations the one nearest to the mesh's given axes is taken.
  kFree,
  /// The order: the surface's second moment is largest along x and least along z. Four rotations are left, half turns
  /// about the axes (the paper's pca4); of these the one nearest to the given axes is taken.
  kOrdered,
  /// The directions, too (the paper's pca): x and y point to the side of the centre of mass with more of the surface's
  /// area, z follows by the right-hand rule. Where the area is divided more equally across x or y than across z, the
  /// two axes of the most unequal halves are so directed, and the third follows.
  kDefinite,
};

struct Axes {
  Rotation rotation;     ///< one of the 24 of the frame
  bool resolved = true;  ///< false if moments or halves that had to be told apart are equal within 1e-9
};

/// A frame's axes by a rule. The same for copies of an object in any position, orientation and size, unless it is not
/// resolved: then the object looks nearly alike either way, and any choice is as good. Throws MeshError if the mesh has
/// no area.
Axes resolve_axes(const Mesh& mesh, const Rotation& frame, AxisRule rule);

}  // namespace rectilin::pose
