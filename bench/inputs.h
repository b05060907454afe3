// What the benchmarks measure on.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rectilin/measure/area_vectors.h"

namespace rectilin::bench {

/// A smooth closed surface with bumps of about `faces` triangles, all of different directions.
Mesh smooth_mesh(std::size_t faces);

/// Its area vectors. The last one asked for is kept, so benchmarks of one size should stand
/// together.
const AreaVectors& smooth_vectors(std::size_t faces);

/// A cylinder's sides as area vectors: every one lies across `cylinder_axis()`.
AreaVectors cylinder_vectors(std::size_t sides);
Vector3 cylinder_axis();

/// Uniform on the sphere; always the same.
std::vector<Vector3> random_directions(std::size_t count);

/// Axes of frames within about `radius` radians of a frame of their own for each `group`
/// directions, as a local search or a cell of branch and bound asks for them.
std::vector<Vector3> local_directions(std::size_t count, std::size_t group, double radius);

/// Hands out one stretch of a long list of directions after the other, so that caches hold
/// nothing but what every direction touches.
class Directions {
 public:
  Directions(std::vector<Vector3> all, std::size_t batch) : all_(std::move(all)), batch_(batch) {}

  std::span<const Vector3> next() {
    if (begin_ + batch_ > all_.size()) begin_ = 0;
    begin_ += batch_;
    return std::span(all_).subspan(begin_ - batch_, batch_);
  }

 private:
  std::vector<Vector3> all_;
  std::size_t batch_, begin_ = 0;
};

}  // namespace rectilin::bench
