#include "features/light_field.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "rectilin/base/rotation.h"

namespace rectilin::retrieval {
namespace {

/// The first ten vertices of the dodecahedron with a face across the z-axis: five round that face, five of the belt.
std::array<Vector3, kCameras> dodecahedron() {
  const double golden = std::numbers::phi, degree = std::numbers::pi / 180;
  const double circumradius = std::sqrt(3.0), edge = 2 / golden;
  const double small = edge / (2 * std::sin(36 * degree));  // radius of the face's circle
  const double high = std::sqrt(3 - small * small);         // its height
  const double wide = golden * small, low = std::sqrt(std::max(0.0, 3 - wide * wide));
  std::array<Vector3, kCameras> vertices;
  for (std::size_t i = 0; i < 5; ++i) {
    const double a = (36 + 72 * static_cast<double>(i)) * degree;
    vertices[i] = Vector3(small * std::cos(a), small * std::sin(a), high) / circumradius;
    const double b = (-36 + 36 * static_cast<double>(i)) * degree;
    vertices[5 + i] = Vector3(wide * std::cos(b), wide * std::sin(b), i % 2 == 0 ? low : -low) / circumradius;
  }
  return vertices;
}

/// Rodrigues vectors of the ten turns.
constexpr double kTurns[kFields][3] = {
    {0, 0, 0},
    {-0.076001, 0.283294, 0.171972},
    {0.051626, -0.314153, 0.293676},
    {-0.003737, -0.316244, -0.241828},
    {0.016217, -0.244233, 0.041623},
    {0.261912, -0.056447, -0.041455},
    {0.001809, -0.008923, -0.211413},
    {0.297818, -0.099929, 0.201438},
    {-0.244257, -0.072917, 0.134917},
    {0.007166, 0.002926, 0.219161},
};

/// The camera whose axis a direction is nearest to.
std::size_t axis_of(const std::array<Vector3, kCameras>& axes, const Vector3& direction) {
  std::size_t best = 0;
  for (std::size_t c = 1; c < kCameras; ++c)
    if (std::abs(axes[c].dot(direction)) > std::abs(axes[best].dot(direction))) best = c;
  return best;
}

}  // namespace

const std::array<Vector3, kFields * kCameras>& light_field_directions() {
  static const auto directions = [] {
    std::array<Vector3, kFields * kCameras> all;
    const auto base = dodecahedron();
    for (std::size_t f = 0; f < kFields; ++f) {
      const Rotation turn = rotation_from_rodrigues({kTurns[f][0], kTurns[f][1], kTurns[f][2]});
      for (std::size_t c = 0; c < kCameras; ++c) all[f * kCameras + c] = turn.matrix() * base[c];
    }
    return all;
  }();
  return directions;
}

const std::vector<std::array<std::uint8_t, kCameras>>& light_field_rotations() {
  static const auto rotations = [] {
    const auto axes = dodecahedron();
    std::vector<Vector3> vertices(axes.begin(), axes.end());
    for (const Vector3& v : axes) vertices.push_back(-v);
    // A rotation is known by where it takes an edge: 30 edges, two ways round.
    const auto frame = [](const Vector3& a, const Vector3& b) {
      Eigen::Matrix3d m;
      m.col(0) = a;
      m.col(1) = (b - a.dot(b) * a).normalized();
      m.col(2) = m.col(0).cross(m.col(1));
      return m;
    };
    const double near = std::sqrt(5.0) / 3;  // cosine between neighbours
    const auto adjacent = [&](const Vector3& a, const Vector3& b) { return std::abs(a.dot(b) - near) < 1e-6; };
    std::vector<std::array<std::uint8_t, kCameras>> all;
    const Eigen::Matrix3d from = frame(axes[0], axes[1]);
    for (const Vector3& a : vertices)
      for (const Vector3& b : vertices) {
        if (!adjacent(a, b)) continue;
        const Eigen::Matrix3d turn = frame(a, b) * from.transpose();
        std::array<std::uint8_t, kCameras> permutation;
        for (std::size_t c = 0; c < kCameras; ++c)
          permutation[c] = static_cast<std::uint8_t>(axis_of(axes, turn * axes[c]));
        all.push_back(permutation);
      }
    return all;
  }();
  return rotations;
}

}  // namespace rectilin::retrieval
