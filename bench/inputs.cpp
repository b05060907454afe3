#include "inputs.h"

#include <cmath>
#include <numbers>

#include "rectilin/base/rotation.h"
#include "rectilin/mesh/shapes.h"

namespace rectilin::bench {

Mesh smooth_mesh(std::size_t faces) { return make_shape(Spec::parse("blob?faces=" + std::to_string(faces))); }

const AreaVectors& smooth_vectors(std::size_t faces) {
  static std::size_t held = 0;
  static AreaVectors vectors;
  if (held != faces) {
    vectors = {};  // first, or two large ones would be in memory
    vectors = area_vectors(smooth_mesh(faces));
    held = faces;
  }
  return vectors;
}

Vector3 cylinder_axis() { return Vector3(0.3, 0.5, 0.7).normalized(); }

AreaVectors cylinder_vectors(std::size_t sides) {
  const Vector3 p = cylinder_axis().unitOrthogonal(), q = cylinder_axis().cross(p);
  std::vector<Vector3> vectors;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
    vectors.push_back(std::cos(angle) * p + std::sin(angle) * q);
  }
  return area_vectors(std::move(vectors));
}

std::vector<Vector3> random_directions(std::size_t count) {
  Random random(1);
  std::vector<Vector3> result;
  while (result.size() < count) result.push_back(random_rotation(random).axis(0));
  return result;
}

std::vector<Vector3> local_directions(std::size_t count, std::size_t group, double radius) {
  Random random(2);
  std::vector<Vector3> result;
  while (result.size() < count) {
    const Rotation centre = random_rotation(random);
    for (std::size_t k = 0; k < group; ++k) {
      const Vector3 turn(random.normal(), random.normal(), random.normal());
      result.push_back((rotation_from_vector(radius * turn) * centre).axis(static_cast<int>(k % 3)));
    }
  }
  return result;
}

}  // namespace rectilin::bench
