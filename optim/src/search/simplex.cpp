#include "search/simplex.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "search/turned.h"

namespace rectilin {
namespace {

/// The chordal mean: for nearby rotations it minimises the sum of squared distances of the matrices.
Rotation mean(const Rotation& a, const Rotation& b, const Rotation& c) {
  const Eigen::Vector4d qa = a.quaternion().coeffs();
  Eigen::Vector4d sum = qa;
  for (const Rotation* r : {&b, &c}) {
    const Eigen::Vector4d q = r->quaternion().coeffs();
    sum += q.dot(qa) < 0 ? Eigen::Vector4d(-q) : q;
  }
  return Rotation::from_quaternion(Eigen::Quaterniond(sum));
}

}  // namespace

Rotation nearest_copy(const Rotation& rotation, const Rotation& reference) {
  return reduce_to_zone(rotation * reference.inverse()) * reference;
}

Rotation along_geodesic(const Rotation& a, const Rotation& b, double t) {
  const Eigen::AngleAxisd turn((b * a.inverse()).quaternion());
  return turned(a, t * turn.angle() * turn.axis());
}

Simplex Simplex::around(const Rotation& start, double size, Evaluator& evaluator, Random& random) {
  const Eigen::Matrix3d orientation = random_rotation(random).matrix();
  // Three edges of a regular tetrahedron that meet in a corner: diagonals of the faces of a cube.
  const Eigen::Matrix3d edges = (Eigen::Matrix3d() << 0, 1, 1, 1, 0, 1, 1, 1, 0).finished() / std::sqrt(2.0);
  std::array<Vertex, 4> vertices;
  vertices[0] = {start, evaluator.value(start)};
  for (int i = 0; i < 3; ++i) {
    const Rotation corner = turned(start, size * (orientation * edges.col(i)));
    vertices[i + 1] = {corner, evaluator.value(corner)};
  }
  return Simplex(vertices);
}

Simplex::Simplex(std::array<Vertex, 4> vertices) : vertices_(std::move(vertices)) {
  for (Vertex& v : vertices_) v.rotation = nearest_copy(v.rotation, vertices_[0].rotation);
  sort();
}

void Simplex::step(Evaluator& evaluator) {
  Vertex& worst = vertices_[3];
  const Rotation centre = mean(vertices_[0].rotation, vertices_[1].rotation, vertices_[2].rotation);
  const auto at = [&](double t) {
    const Rotation rotation = along_geodesic(worst.rotation, centre, t);
    return Vertex{rotation, evaluator.value(rotation)};
  };

  const Vertex reflected = at(2);
  if (reflected.value < vertices_[0].value) {
    const Vertex expanded = at(3);
    worst = expanded.value < reflected.value ? expanded : reflected;
  } else if (reflected.value < vertices_[2].value) {
    worst = reflected;
  } else {
    const bool outside = reflected.value < worst.value;
    const Vertex contracted = at(outside ? 1.5 : 0.5);
    if (contracted.value < std::min(reflected.value, worst.value)) {
      worst = contracted;
    } else {
      for (Vertex& v : std::span(vertices_).subspan(1)) {
        v.rotation = along_geodesic(vertices_[0].rotation, v.rotation, 0.5);
        v.value = evaluator.value(v.rotation);
      }
    }
  }
  sort();
}

double Simplex::radius() const {
  double radius = 0;
  for (const Vertex& v : vertices_) radius = std::max(radius, angle_between(vertices_[0].rotation, v.rotation));
  return radius;
}

void Simplex::sort() { std::ranges::stable_sort(vertices_, {}, &Vertex::value); }

}  // namespace rectilin
