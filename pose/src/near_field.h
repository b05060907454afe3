// How near a point with a normal is to a surface that has a like normal there.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "samples.h"

namespace rectilin::pose {

/// A grid whose cells know the nearest of many samples of a surface, up to a reach beyond which nothing counts.
/// Samples stand for flat discs, so distances are good to much less than the distance between samples.
class NearField {
 public:
  /// `width` is the standard deviation of the bell curve that turns distances into likeness; the reach is 3 of it.
  NearField(Samples samples, double width);

  /// exp(-d^2 / (2 width^2)) (n . m)^2 with d the distance to the surface and m its normal there: 1 for a point on the
  /// surface whose normal is n, 0 for one far away or at right angles. n of unit length.
  double likeness(const Vector3& point, const Vector3& normal) const;

  /// The sample nearest to a point, roughly; nothing if it is out of reach.
  std::optional<std::size_t> nearest(const Vector3& point) const;
  const Samples& samples() const { return samples_; }

 private:
  std::size_t cell(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * counts_[1] + static_cast<std::size_t>(y)) * counts_[0] +
           static_cast<std::size_t>(x);
  }

  Samples samples_;
  double width_, cell_size_;
  Vector3 origin_;
  int counts_[3];
  std::vector<std::uint32_t> nearest_;  // of a cell's middle; kNone beyond the reach
};

}  // namespace rectilin::pose
