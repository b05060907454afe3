// What of a mesh can bound its silhouette: the edges whose triangles do not lie on both sides.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rectilin/mesh/mesh.h"
#include "rectilin/render/silhouette_area.h"
#include "silhouette/multiplicity.h"

namespace rectilin::render {

/// A mesh prepared for silhouettes: vertices at one place are one, edges are numbered.
class Silhouette::Contours {
 public:
  explicit Contours(const Mesh& mesh);

  struct Picture {
    std::vector<JumpEdge> edges;
    double slack;  ///< by how much the area may be off because corners were rounded
  };
  /// The contour seen along a unit vector, in units of 2^exponent().
  Picture seen_along(const Vector3& direction) const;

  int exponent() const { return exponent_; }

 private:
  struct Face {
    std::array<std::uint32_t, 3> corners, edges;
    std::array<std::int8_t, 3> along;  ///< +1 if the side runs from its edge's first end to its second, else -1
  };

  int exponent_ = 0;
  double radius_ = 0;      ///< greatest distance from the origin
  double perimeters_ = 0;  ///< summed over all triangles
  std::vector<Vector3> points_;
  std::vector<Face> faces_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
};

}  // namespace rectilin::render
