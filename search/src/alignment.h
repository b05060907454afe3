// Is one surface another that was turned, scaled, moved or mirrored?
#pragma once

#include <vector>

#include "rectilin/mesh/mesh.h"
#include "rectilin/retrieval/model.h"

namespace rectilin::search {

/// A surface to be laid on others: in its principal axes, the centre of mass at the origin, the root mean square
/// distance from it 1.
class AlignedShape {
 public:
  /// Throws MeshError if the mesh has no area.
  explicit AlignedShape(const retrieval::Model& model);

  struct Sample {
    Vector3 point, normal;
    std::uint32_t triangle;
  };
  const std::vector<Sample>& samples() const { return samples_; }

  /// Means of squares of coordinates along the principal axes, largest first; their sum is 1.
  const Vector3& moments() const { return moments_; }
  /// Rows: the principal axes, and those of the largest rectilinearity, in the file's coordinates.
  const Eigen::Matrix3d& principal() const { return principal_; }
  const Eigen::Matrix3d& rectilinear() const { return rectilinear_; }
  double unit() const { return unit_; }  ///< of length, in the file's

  /// The point of the surface next to p, nearly: of the triangles that the nearest samples lie in and of the flat discs
  /// they stand for. Infinitely far if there are none within reach.
  struct Foot {
    Vector3 point, normal;
    double distance;
  };
  Foot nearest(const Vector3& p) const;

 private:
  std::size_t cell_of(const Vector3& p, const std::array<int, 3>& step) const;

  std::vector<std::array<Vector3, 3>> triangles_;
  std::vector<Sample> samples_;
  Vector3 moments_, low_;
  Eigen::Matrix3d principal_, rectilinear_;
  double unit_ = 1, cell_ = 1, disc_ = 0;
  std::array<int, 3> counts_{};
  std::vector<std::uint32_t> begins_, order_;  ///< samples by cell
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

}  // namespace rectilin::search
