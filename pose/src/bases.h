// Flat sides of a convex hull: what an object may stand on or lean against.
#pragma once

#include <cstddef>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::pose {

/// The hull's faces as seen along a direction, those within about 8 degrees of facing it counting as flat. Feet of a
/// chair, the wheels of a car and the foot of a vase make large faces of the hull, whatever is between them.
class Bases {
 public:
  /// Keeps what it needs of the convex hull.
  explicit Bases(const Mesh& hull);

  /// How much of the hull's outline along an axis (unit vector) is flat there, from the flatter of the two sides: a sum
  /// over its faces, A exp(-a^2 / (2 s^2)), a the angle to the axis and s = 0.14, over the area of the outline. A box
  /// has 1 along its edges, a sphere about 0.04 everywhere.
  double share(const Vector3& axis) const;

  /// Outward directions of the flattest sides, by area within about 3 degrees; `count` at most, no two within 10
  /// degrees of each other or of each other's opposite.
  std::vector<Vector3> flattest(std::size_t count) const;

 private:
  struct Face {
    Vector3 normal;
    double area;
  };
  std::vector<Face> faces_;  // largest first
};

}  // namespace rectilin::pose
