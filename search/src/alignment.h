// Is one surface another that was turned, scaled, moved or mirrored?
#pragma once

#include <vector>

#include "rectilin/mesh/mesh.h"
#include "rectilin/retrieval/model.h"
#include "rectilin/search/overlay.h"
#include "surface_tree.h"

namespace rectilin::search {

/// A surface to be laid on others: in its principal axes, the centre of mass at the origin, the root mean square
/// distance from it 1.
class AlignedShape {
 public:
  /// Throws MeshError if the mesh has no area.
  explicit AlignedShape(const retrieval::Model& model);

  /// Points spread evenly over the surface.
  const std::vector<Vector3>& samples() const { return samples_; }

  /// Means of squares of coordinates along the principal axes, largest first; their sum is 1.
  const Vector3& moments() const { return moments_; }
  /// Rows: the principal axes, and those of the largest rectilinearity, in the file's coordinates.
  const Eigen::Matrix3d& principal() const { return principal_; }
  const Eigen::Matrix3d& rectilinear() const { return rectilinear_; }
  double unit() const { return unit_; }              ///< of length, in the file's
  const Vector3& centre() const { return centre_; }  ///< of mass, in the file's coordinates

  const SurfaceTree& tree() const { return tree_; }
  const SurfaceTree& vertex_tree() const { return vertex_tree_; }  ///< of the vertices alone
  /// Those of triangles, each once.
  const std::vector<Vector3>& vertices() const { return vertices_; }

 private:
  std::vector<Vector3> samples_, vertices_;
  SurfaceTree tree_{{}}, vertex_tree_{{}};
  Vector3 moments_, centre_;
  Eigen::Matrix3d principal_, rectilinear_;
  double unit_ = 1;
};

struct Fit {
  double distance = 0;  ///< root mean square of the distances of both surfaces' samples from the other, in radii
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();  ///< turns, scales and perhaps reflects the second shape
  Vector3 shift = Vector3::Zero();
};

/// The best fit of `second` to `first` without or with a reflection.
Fit best_fit(const AlignedShape& first, const AlignedShape& second, bool mirrored);

/// The best of the 24 turns that take the second's frame of largest rectilinearity to the first's, as it is: shapes
/// that are merely alike are not tilted to fit a little better.
Fit best_frame(const AlignedShape& first, const AlignedShape& second);

/// The way back; the distance is kept.
Fit inverse(const Fit& fit);

/// What a fit of the second shape to the first does to coordinates of the second file: they become those of the first.
Placement placement(const AlignedShape& first, const AlignedShape& second, const Fit& fit);

/// A fit that lays vertices on vertices.
struct VertexFit {
  Fit fit;           ///< of the coarse shape to the fine one
  double share = 0;  ///< of the coarse mesh's vertices that are vertices of the fine one, within 0.001 radii
};

/// The surfaces of a shape and of its simplification can be far apart, but most ways of simplifying leave vertices
/// where they were. `fit` is refined so that many vertices lie on the surface of the fine shape, those that do not
/// count for little (an M-estimator with the weights of Geman and McClure 1987). It is vertices that are counted then:
/// of a box all eight can lie on the surface of a larger one.
VertexFit vertex_fit(const AlignedShape& fine, const AlignedShape& coarse, Fit fit);

}  // namespace rectilin::search
