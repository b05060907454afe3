// A mesh made ready for finding poses: of size one, centred, with the areas, normals and moments of its surface.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// The triangles of positive area, moved so that the surface's centre of mass is the origin, and scaled by a power of
/// two so that the largest coordinate extent lies in [1/2, 1). Powers of two cost no digits, so a mesh in other units
/// gives the same bits, and coordinates of 1e120 do not overflow when squared.
struct Surface {
  Mesh mesh;
  std::vector<double> areas;     ///< of each triangle
  std::vector<Vector3> normals;  ///< of each triangle, of unit length; orientation carries no meaning
  double area = 0;               ///< sum of `areas`
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();  ///< mean of x x' over the surface
  double rms = 0;                                     ///< root mean square distance of the surface from the origin
  double radius = 0;  ///< largest distance of a corner from the origin, corners of triangles without area included

  int exponent = 0;                  ///< lengths of the mesh given are those here times 2^exponent
  Vector3 centre = Vector3::Zero();  ///< the origin, in the coordinates of the mesh given
};

/// Throws MeshError if the total area is zero.
Surface make_surface(const Mesh& mesh);

}  // namespace rectilin::pose
