// The area of a mesh's silhouette, enclosed with certainty.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rectilin/mesh/mesh.h"

namespace rectilin::render {

/// An interval of areas, in the square of the mesh's unit: 0 <= lower <= upper.
struct AreaInterval {
  double lower = 0, upper = 0;
};

/// The area of the union of a mesh's triangles, projected along a direction: what the mesh's shadow covers. Any soup of
/// triangles will do, open, crossing itself, oriented or not, of coordinates of any size.
///
///     Silhouette silhouette(mesh);
///     AreaInterval area = silhouette.area({0, 0, 1});        // to a relative 1e-6
///     AreaInterval rough = silhouette.area({1, 2, 3}, 1e-3);
///
/// The interval holds the exact area, for the coordinates as they are: all roundings are accounted for. It is at most
/// `tolerance` times its upper end wide, unless that is less than rounding allows, which is about 1e-14 times the
/// summed perimeters of the triangles times the mesh's radius: so of a flat mesh seen edge on only the upper end is
/// small.
///
/// How: a point's multiplicity is the number of triangles over it. It changes across those edges alone whose triangles
/// do not lie on both sides, the contour; the picture is halved again and again, cells are settled that are covered or
/// empty beyond doubt, and cells of few edges are integrated strip by strip. See papers/silhouettes.md.
///
/// Making one costs about as much as a few areas. Thread safe: areas may be asked for from many threads.
class Silhouette {
 public:
  explicit Silhouette(const Mesh& mesh);
  ~Silhouette();
  Silhouette(Silhouette&&) noexcept;
  Silhouette& operator=(Silhouette&&) noexcept;

  /// `direction` need not be of unit length; std::invalid_argument if it is zero or not finite, or if the tolerance is
  /// not from 0 to 1. The area is the same, bit for bit, from one call to another; for opposite directions up to
  /// rounding.
  AreaInterval area(const Vector3& direction, double tolerance = 1e-6) const;

  /// One for each direction, in their order; in parallel, with the same bits for any number of threads.
  std::vector<AreaInterval> areas(std::span<const Vector3> directions, double tolerance = 1e-6) const;

 private:
  class Contours;
  std::unique_ptr<const Contours> contours_;
};

/// The same for a single direction.
AreaInterval silhouette_area(const Mesh& mesh, const Vector3& direction, double tolerance = 1e-6);

}  // namespace rectilin::render
