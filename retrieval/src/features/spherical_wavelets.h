// Wavelets on the sphere, for functions given at the vertices of a subdivided octahedron.
#pragma once

#include <span>
#include <vector>

#include "rectilin/render/view_sphere.h"

namespace rectilin::retrieval {

/// The lifted linear wavelets of Schroeder and Sweldens (Spherical wavelets, SIGGRAPH 1995). From the finest level to
/// the octahedron: a vertex that emerged in the middle of an edge keeps what it differs by from the mean of the edge's
/// ends, and gives so much of that to the ends that the function's integral stays what it was.
class SphericalWavelets {
 public:
  /// The sphere must outlive it.
  explicit SphericalWavelets(const render::ViewSphere& sphere);

  /// Coefficients of a function, one for each vertex of the sphere, in the vertices' order: means at the first six,
  /// then the differences at the vertices of each finer level. Rotations of the cube permute them as they permute
  /// vertices. They are scaled by the square root of the area they stand for, so that the sum of their squares is about
  /// the integral of the function's square.
  std::vector<double> coefficients(std::vector<double> values) const;

  /// The function of such coefficients: the inverse of the above.
  std::vector<double> values(std::vector<double> coefficients) const;

  /// Share of the sphere's area that vertex k stands for on the level on which it emerged.
  std::span<const double> areas() const { return areas_; }

 private:
  std::size_t begin_of(int level) const;  ///< number of vertices on the level below, 0 for level 0

  const render::ViewSphere& sphere_;
  std::vector<double> areas_;
  std::vector<std::vector<double>> by_level_;  ///< areas of all vertices of each level
};

}  // namespace rectilin::retrieval
