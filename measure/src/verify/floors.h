// Lower bounds of h(u) - u . F u, h(u) = sum |u . v_i|, where an axis of the frame points to.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/part.h"

namespace rectilin::verification {

struct Face {
  double x, y, z;  // area vector, in units of the surface
};

/// A subdivision of half the sphere (h is even) into triangles, refined where a claim asks for it. What was found for
/// one claim serves the next.
class Floors {
 public:
  enum class Answer { kHolds, kFails, kTooMany };

  /// F is symmetric, its entries at most 1.
  Floors(const std::vector<Face>& faces, const Eigen::Matrix3d& form);

  /// Is h(r_k) - r_k . F r_k >= floors[k] for the axes r_k of all rotations in the box? If that does not show, halves
  /// of the box are tried, down to `halvings`. kTooMany: so many triangles are not worth it.
  Answer check(const std::array<double, 3>& floors, const Part& part, int halvings);

 private:
  using Vector = Eigen::Vector3d;
  using Extended = Eigen::Matrix<long double, 3, 1>;

  struct Triangle {
    std::array<Vector, 3> corners;  // unit vectors
    double bound = -1e9;            // it is nowhere less
    std::int32_t above = -1, parts = -1, list = -1;
    std::int8_t level = 0;
    bool cut = false;  // `bound` is at least that of a cut
  };
  /// Faces that have no common sign on a triangle, and the sum of the others with theirs.
  struct List {
    std::vector<std::uint32_t> faces;
    Extended settled = Extended::Zero();
  };
  struct Sweep;

  bool covers(std::int32_t at, const Sweep& sweep, double mirror, double floor);
  bool show_cut(std::int32_t at, const Sweep& sweep, double mirror, double floor);
  double least(const Vector& g, const std::array<Vector, 3>& p) const;
  const List& list_over(std::int32_t at);
  List narrowed(const List& list, const std::array<Vector, 3>& corners) const;
  void divide(std::int32_t at);

  const std::vector<Face>& faces_;
  const Eigen::Matrix3d form_;
  std::vector<Triangle> triangles_;  // the first four make up half the sphere
  std::vector<List> lists_;          // the first one: all faces
  bool too_many_ = false;
};

}  // namespace rectilin::verification
