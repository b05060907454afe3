#include "rectilin/measure/projected_area.h"

#include <cmath>

namespace rectilin {
namespace {
double h_of(const AreaVectors& v, const Vector3& u, Vector3* g) {
  Vector3 sum = Vector3::Zero();
  double h = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double d = u.dot(v[i]);
    h += std::abs(d);
    if (g) sum += d < 0 ? Vector3(-v[i]) : v[i];
  }
  if (g) *g = sum;
  return h;
}
}  // namespace

ProjectedArea::ProjectedArea(AreaVectors vectors, std::string name)
    : vectors_(std::move(vectors)), name_(std::move(name)) {}

void ProjectedArea::values(std::span<const Rotation> rotations, std::span<double> values) const {
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    double p = 0;
    for (int k = 0; k < 3; ++k) p += h_of(vectors_, rotations[i].axis(k), nullptr);
    values[i] = p / vectors_.total;
  }
}

void ProjectedArea::cuts(std::span<const Rotation> rotations, std::span<Cut> cuts) const {
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    cuts[i].value = 0;
    for (int k = 0; k < 3; ++k) {
      Vector3 g;
      cuts[i].value += h_of(vectors_, rotations[i].axis(k), &g) / vectors_.total;
      cuts[i].gradient.row(k) = g.transpose() / vectors_.total;
    }
  }
}

}  // namespace rectilin
