// How near a point with a normal is to a surface that has a like normal there.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "samples.h"

namespace rectilin::pose {

/// A grid whose cells know the nearest of many samples of a surface, up to a reach beyond which nothing counts, and the
/// nearest that faces another way, for at edges the surface has two normals. Samples stand for flat discs, so distances
/// are good to much less than the distance between samples.
class NearField {
 public:
  /// `width` is the standard deviation of the bell curve that turns distances into likeness; the reach is 3 of it.
  NearField(Samples samples, double width);

  /// exp(-d^2 / (2 width^2)) (n . m)^2 with d the distance to the surface and m its normal there: 1 for a point on the
  /// surface whose normal is n, 0 for one far away or at right angles. n of unit length.
  double likeness(const Vector3& point, const Vector3& normal) const;

  /// The sample that is most like a point with a normal, of the two that its cell knows; nothing if out of reach.
  std::optional<std::size_t> match(const Vector3& point, const Vector3& normal) const;
  const Samples& samples() const { return samples_; }

 private:
  std::size_t cell(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * counts_[1] + static_cast<std::size_t>(y)) * counts_[0] +
           static_cast<std::size_t>(x);
  }

  struct Pair {
    std::uint32_t nearest, other;  ///< of the cell's middle; kNone beyond the reach
  };
  const Pair* at(const Vector3& point) const;
  double likeness(std::uint32_t sample, const Vector3& point, const Vector3& normal) const;

  Samples samples_;
  double width_, cell_size_;
  Vector3 origin_;
  int counts_[3];
  std::vector<Pair> pairs_;
};

}  // namespace rectilin::pose
