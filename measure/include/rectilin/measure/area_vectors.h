// The area vectors of a mesh: all that the measure needs to know about it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rectilin/base/cache_aligned.h"
#include "rectilin/base/rotation.h"
#include "rectilin/mesh/mesh_view.h"

namespace rectilin {

using AlignedDoubles = CacheAligned<double>;

/// The area vectors of a mesh, one for each distinct direction, as a structure of arrays.
///
/// The area vector of a face is half the cross product of two edges (eqs. 5-6): its length is the face's area, its
/// direction the normal. P(R) depends only on these vectors, up to sign, and those of faces with parallel normals add
/// up (|u.v| + |u.cv| = |u.(1+c)v|), so each distinct direction is kept once.
///
/// If the longest vector is very long or very short (about 2^64 or 2^-64), lengths are scaled by a power of two, so
/// that products of their squares neither overflow nor vanish. Neither R nor any ratio of areas depends on the scale;
/// area() undoes it.
struct AreaVectors {
  AlignedDoubles x, y, z;  ///< components, on one hemisphere, ordered so that neighbours have similar directions
  double total = 0;        ///< S, the sum of all faces' areas, in the scaled unit
  int exponent = 0;        ///< true lengths are scaled lengths times 2^exponent
  std::size_t faces = 0;   ///< number of triangles with positive area

  std::size_t size() const { return x.size(); }
  Vector3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vector3& v) { x[i] = v.x(), y[i] = v.y(), z[i] = v.z(); }

  /// Surface area in the square of the mesh's own unit; infinite or zero if that is out of double's range.
  double area() const;
};

/// The area vectors of a mesh. Two directions count as one if they differ by at most kParallel radians, which is
/// rounding level: merging them changes P by less than kParallel times the merged area. The result does not depend on
/// the number of threads. Throws MeshError if the total area is zero or a corner is not finite.
AreaVectors area_vectors(const MeshView& mesh);

/// The same for given vectors, of any scale, for instance to test the objective without a mesh. Throws MeshError if one
/// is not finite.
AreaVectors area_vectors(std::vector<Vector3> vectors);

/// The same for normals with weights, such as those of a point cloud or a Gauss map: vector i has the direction of
/// normal i, whatever the normal's length, and the length weights[i]; without weights all are 1. Throws MeshError for a
/// normal that is zero or not finite or a weight that is negative or not finite, naming which one; if there are not as
/// many weights as normals; and if all weights are zero.
AreaVectors area_vectors_of_normals(std::span<const Vector3> normals, std::span<const double> weights = {});

/// The area vectors of the mesh turned by `rotation`, in the same order.
AreaVectors rotated(const AreaVectors& vectors, const Rotation& rotation);

inline constexpr double kParallel = 1e-14;

}  // namespace rectilin
