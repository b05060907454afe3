// Where a mesh is seen from, in parallel projection.
#pragma once

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh.h"

namespace rectilin::render {

/// The ball that a picture shows: its centre in the middle, its radius half the picture's width and half the range of
/// depths. In the mesh's coordinates and unit.
struct Ball {
  Vector3 centre = Vector3::Zero();
  double radius = 1;
};

/// The middle of the box around the mesh's triangles, and the largest distance of their corners from it: whatever the
/// direction, the mesh fits into the picture. Right for coordinates of any size. A mesh without extent has radius 0.
Ball ball_around(const Mesh& mesh);

/// The picture's axes for a viewer in a direction (unit vector from the mesh to the viewer): the rows are its right,
/// its up and the direction, right-handed. `up` is turned upward as far as it can be; for a viewer along `up` itself
/// the next axis in the order x, y, z, x takes its place. Opposite directions have opposite rights and the same up,
/// exactly, so their silhouettes are mirror images of each other, left to right.
Rotation frame_towards(const Vector3& direction, const Vector3& up = Vector3::UnitY());

}  // namespace rectilin::render
