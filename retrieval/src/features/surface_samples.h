// Points spread evenly over a mesh's surface, the same for the same triangles.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::retrieval {

struct SurfacePoint {
  Vector3 position;
  std::uint32_t triangle;
};

/// Draws points uniformly by area, from numbers in [0, 1) that the caller spreads.
class SurfaceSampler {
 public:
  /// Throws MeshError if the mesh has no area.
  explicit SurfaceSampler(const Mesh& mesh);

  /// `u` chooses the triangle, `s` and `t` the point inside it. Vectors do not turn the choice: a rotated mesh gets the
  /// rotated points.
  SurfacePoint at(double u, double s, double t) const;

  /// Unit normal of a triangle of positive area, by the order of its corners.
  const Vector3& normal(std::uint32_t triangle) const { return normals_[triangle]; }

 private:
  const Mesh& mesh_;
  std::vector<double> upto_;  ///< share of the area in the triangles up to each
  std::vector<Vector3> normals_;
};

/// Point i of the additive recurrence in D dimensions whose steps are powers of the root of x^(D+1) = x + 1 (Roberts
/// 2018): evenly spread for any number of points.
template <std::size_t D>
class SpreadNumbers {
 public:
  SpreadNumbers() {
    double root = 2;
    for (int i = 0; i < 100; ++i) root = root_step(root);
    double step = 1;
    for (double& s : steps_) s = step /= root;
  }
  std::array<double, D> at(std::size_t i) const {
    std::array<double, D> x;
    for (std::size_t d = 0; d < D; ++d) {
      const double value = 0.5 + steps_[d] * static_cast<double>(i + 1);
      x[d] = value - static_cast<double>(static_cast<std::size_t>(value));
    }
    return x;
  }

 private:
  static double root_step(double x) {  // Newton
    double power = 1;
    for (std::size_t d = 0; d < D; ++d) power *= x;
    return x - (power * x - x - 1) / (static_cast<double>(D + 1) * power - 1);
  }
  std::array<double, D> steps_{};
};

}  // namespace rectilin::retrieval
