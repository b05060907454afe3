#include "claims/inequalities.h"

#include <algorithm>
#include <cmath>

namespace rectilin::paper::claims {
namespace {

const double kSqrt3 = std::sqrt(3.0);

/// Some random rotations, the best rotation, and one that takes the normal of the first face to `target`.
std::vector<Rotation> rotations_for(const TestMesh& tested, Random& random, const Vector3& target) {
  std::vector<Rotation> rotations{tested.best.rotation};
  for (int i = 0; i < 4; ++i) rotations.push_back(random_rotation(random));
  rotations.push_back(frame_about(target.normalized()).inverse() * frame_about(tested.vectors()[0].normalized()));
  return rotations;
}

/// The least value of room(|R n|_1) over all faces, with normals n, and all rotations R.
template <class Room>
Finding check_faces(const TestMesh& tested, const std::vector<Rotation>& rotations, Room room) {
  Finding finding{.where = tested.source};
  for (const Rotation& rotation : rotations)
    for (std::size_t i = 0; i < tested.vectors().size(); ++i) {
      const Vector3 normal = tested.vectors()[i].normalized();
      const double margin = room((rotation.matrix() * normal).lpNorm<1>());
      if (margin < finding.margin) finding.margin = margin, finding.rotation = rotation;
    }
  return finding;
}

}  // namespace

Finding check_lower_per_face(const TestMesh& tested, Random random) {
  return check_faces(tested, rotations_for(tested, random, Vector3::UnitZ()),
                     [](double projected) { return projected - 1; });
}

Finding check_upper_per_face(const TestMesh& tested, Random random) {
  return check_faces(tested, rotations_for(tested, random, Vector3::Ones()),
                     [](double projected) { return kSqrt3 - projected; });
}

Sampled greatest_ratio(const Objective& objective, Random random, int count) {
  std::vector<Rotation> rotations;
  for (int i = 0; i < count; ++i) rotations.push_back(random_rotation(random));
  std::vector<double> values(rotations.size());
  objective.values(rotations, values);
  const auto greatest = std::max_element(values.begin(), values.end());
  return {rotations[static_cast<std::size_t>(greatest - values.begin())], *greatest};
}

Finding check_bounds_of_mesh(const TestMesh& tested, Random random) {
  const Sampled worst = greatest_ratio(*tested.objective, random, 32);
  const double below = tested.best.found - 1, above = kSqrt3 - worst.ratio;
  if (below <= above) return {below, tested.source, nullptr, tested.best.rotation, {}};
  return {above, tested.source, nullptr, worst.rotation, {}};
}

}  // namespace rectilin::paper::claims
