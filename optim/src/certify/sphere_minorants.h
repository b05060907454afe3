// Sharp linear minorants of h on parts of the sphere, for objectives that are nearly constant.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "certify/cell.h"
#include "certify/generator_list.h"

namespace rectilin::bounding {

/// On a nearly round body every cut is tangent to a body that curves away from it, and cells must shrink with the
/// square root of the gap in all three dimensions. But h lives on the sphere, which has two: its minimum over a
/// triangle, less a linear function, can be searched with the few faces whose great circles meet it.
///
/// Holds, for the triangles of a subdivided hemisphere on `levels` levels, a linear function l and the minimum m of
/// h(u) - l . u over the triangle, from below and within the tolerance (papers/certificate.md, lemma 3).
/// Immutable and thread safe; the same for any number of threads.
class SphereMinorants {
 public:
  /// Throws Stopped once `stop` returns true, which is asked often and by many threads.
  struct Stopped {};
  SphereMinorants(const Generators& generators, int levels, double tolerance, const std::function<bool()>& stop);

  /// l and m with h(x) >= l . x + m for every unit vector x within `angle` radians of the unit vector u.
  std::optional<Minorant> on_cap(const Eigen::Vector3d& u, double angle) const;

  /// (face, direction) pairs the construction looked at.
  std::uint64_t pairs() const { return pairs_; }

 private:
  struct Patch {
    Triangle3 corners;
    Eigen::Vector3d centre;
    double cosine;    // of the angle from the centre to the furthest corner
    double distance;  // of the plane through the corners from the origin
    Minorant minorant;
  };
  class Builder;

  std::vector<std::vector<Patch>> levels_;  // patch i's parts are 4 i ... 4 i + 3 of the next level
  double rounding_ = 0;
  std::uint64_t pairs_ = 0;
};

}  // namespace rectilin::bounding
