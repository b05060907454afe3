// Coordinates of any size brought near 1 without rounding: by a power of two.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rectilin/mesh/mesh.h"

namespace rectilin::render {

inline Vector3 times_power(const Vector3& v, int exponent) {
  return {std::scalbn(v.x(), exponent), std::scalbn(v.y(), exponent), std::scalbn(v.z(), exponent)};
}

/// e such that every coordinate that a triangle uses is below 2^e in size, and one is at least 2^(e-1); 0 if all are 0.
inline int size_exponent(const Mesh& mesh) {
  double size = 0;
  for (const Triangle& t : mesh.triangles)
    for (const auto i : t) size = std::max(size, mesh.vertices[i].lpNorm<Eigen::Infinity>());
  return size > 0 ? std::ilogb(size) + 1 : 0;
}

}  // namespace rectilin::render
