// The exact minimum over the turns about one axis of the frame: the planar problem of Zunic and Rosin (2003).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "rectilin/measure/projected_area.h"

namespace rectilin {

BestTurn ProjectedArea::best_turn(const Rotation& rotation, int k) const {
  constexpr double kQuarter = std::numbers::pi / 2;
  const Vector3 first = rotation.axis((k + 1) % 3), second = rotation.axis((k + 2) % 3);

  // Seen along the axis, an area vector has length rho and angle -psi. The frame turned by t, it adds
  // rho (|cos(t - psi)| + |sin(t - psi)|): period pi/2 in t, a kink at psi, concave elsewhere. So a sum of such
  // terms has its minimum at a kink.
  struct Kink {
    double angle;  // psi reduced to [0, pi/2)
    double x, y;   // rho (cos, sin) of it
  };
  std::vector<Kink> kinks;
  kinks.reserve(vectors_.size());
  for (std::size_t i = 0; i < vectors_.size(); ++i) {
    const Vector3 v = vectors_[i];
    double x = first.dot(v), y = -second.dot(v);
    if (x < 0 || (x == 0 && y < 0)) x = -x, y = -y;
    if (y < 0) std::swap(x, y), x = -x;  // a quarter turn
    if (x == 0 && y == 0) continue;
    const double angle = std::atan2(y, x);
    if (angle >= kQuarter) kinks.push_back({0, y, 0});
    else kinks.push_back({angle, x, y});
  }
  std::ranges::sort(kinks, [](const Kink& a, const Kink& b) {
    return std::tie(a.angle, a.x, a.y) < std::tie(b.angle, b.x, b.y);
  });

  // With (X, Y) the sum over the kinks at or behind t, and (U, V) that over those ahead, the terms add up to
  // X (c + s) + Y (s - c) + U (c - s) + V (s + c), c = cos t, s = sin t.
  double ahead_x = 0, ahead_y = 0, behind_x = 0, behind_y = 0;
  for (const Kink& kink : kinks) ahead_x += kink.x, ahead_y += kink.y;
  double best_angle = 0, least = ahead_x + ahead_y;
  for (const Kink& kink : kinks) {
    behind_x += kink.x, behind_y += kink.y;
    ahead_x -= kink.x, ahead_y -= kink.y;
    const double c = std::cos(kink.angle), s = std::sin(kink.angle);
    const double value = behind_x * (c + s) + behind_y * (s - c) + ahead_x * (c - s) + ahead_y * (s + c);
    if (value < least) least = value, best_angle = kink.angle;
  }
  // The running sums lose digits: the value returned is the one that values() gives there. The quaternion
  // keeps long chains of turns orthonormal.
  BestTurn best;
  best.rotation = Rotation::from_quaternion((rotation_from_vector(best_angle * Vector3::Unit(k)) * rotation).quaternion());
  values({&best.rotation, 1}, {&best.value, 1});
  return best;
}

}  // namespace rectilin
