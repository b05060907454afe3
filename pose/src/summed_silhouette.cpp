#include "rectilin/pose/summed_silhouette.h"

#include <array>
#include <vector>

#include "surface.h"

namespace rectilin::pose {

SummedSilhouette::SummedSilhouette(const Mesh& mesh, double tolerance, std::string name)
    : silhouette_(Mesh()), area_(0), tolerance_(tolerance), name_(std::move(name)) {
  const Surface surface = make_surface(mesh);
  silhouette_ = render::Silhouette(surface.mesh);
  area_ = surface.area;
}

void SummedSilhouette::values(std::span<const Rotation> rotations, std::span<double> values) const {
  std::vector<Vector3> directions;
  for (const Rotation& rotation : rotations)
    for (int k = 0; k < 3; ++k) directions.push_back(rotation.axis(k));
  const std::vector<render::AreaInterval> areas = silhouette_.areas(directions, tolerance_);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    double sum = 0;
    for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) sum += (areas[k].lower + areas[k].upper) / 2;
    values[i] = sum / area_;
  }
}

render::AreaInterval SummedSilhouette::interval(const Rotation& rotation, double tolerance) const {
  constexpr double kRounding = 1e-15;
  render::AreaInterval sum;
  for (int k = 0; k < 3; ++k) {
    const render::AreaInterval area = silhouette_.area(rotation.axis(k), tolerance);
    sum.lower += area.lower;
    sum.upper += area.upper;
  }
  return {sum.lower / area_ * (1 - kRounding), sum.upper / area_ * (1 + kRounding)};
}

}  // namespace rectilin::pose
