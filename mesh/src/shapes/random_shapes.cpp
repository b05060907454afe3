#include "shapes/random_shapes.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes/builder.h"
#include "shapes/round.h"

namespace rectilin::shapes {
namespace {

struct Wave {
  Vector3 vector;
  double phase;
};

Wave random_wave(Random& random, double frequency) {
  Vector3 direction;
  for (double& component : direction) component = random.normal();
  const double length = frequency * random.uniform(0.5, 1);
  return {length * direction.normalized(), random.uniform(0, 2 * std::numbers::pi)};
}

}  // namespace

void Blob::bind(Parameters& parameters) {
  parameters.integer("faces", faces, 8, kMaxFaces, "triangles, rounded down to an even number")
      .integer("waves", waves, 1, 100, "plane waves that make the bumps")
      .real("amplitude", amplitude, 0, 1, "standard deviation of the radius' logarithm")
      .real("frequency", frequency, 0, 100, "largest wave number; the more, the smaller the bumps");
}

/// The radius is the exponential of a sum of waves and so never zero: however bumpy, the shape stays star-shaped.
Mesh Blob::build(Random& random) const {
  std::vector<Wave> all;
  for (int i = 0; i < waves; ++i) all.push_back(random_wave(random, frequency));
  Mesh mesh = Tessellation{.kind = Tessellation::Kind::kEven, .faces = faces}.unit_sphere();
  const double factor = amplitude / std::sqrt(0.5 * waves);  // the mean square of a cosine is 1/2
  for (auto& p : mesh.vertices) {
    double sum = 0;
    for (const auto& wave : all) sum += std::cos(wave.vector.dot(p) + wave.phase);
    p *= std::exp(factor * sum);
  }
  return mesh;
}

void Soup::bind(Parameters& parameters) {
  parameters.integer("faces", faces, 1, 10'000'000, "triangles, no two of which share a vertex")
      .real("size", size, kShortest, kLongest,
            "edge of the cube a triangle's corners are drawn from; its centre is in a unit cube");
}

Mesh Soup::build(Random& random) const {
  const auto point_within = [&random](double edge) {
    Vector3 point;
    for (double& coordinate : point) coordinate = random.uniform(-edge / 2, edge / 2);
    return point;
  };
  Mesh mesh;
  mesh.vertices.reserve(3 * static_cast<std::size_t>(faces));
  mesh.triangles.reserve(static_cast<std::size_t>(faces));
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(faces); ++i) {
    const Vector3 centre = point_within(1);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(centre + point_within(size));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace rectilin::shapes
