// Nelder and Mead's simplex of four rotations.
#pragma once

#include <array>

#include "rectilin/base/random.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// The method of Nelder and Mead (1965) for rotations: geodesics replace the straight lines from the worst vertex
/// through the centre of the others. The vertices stay sorted, the best first.
class Simplex {
 public:
  struct Vertex {
    Rotation rotation;
    double value;
  };

  /// A regular simplex in the tangent space at `start`, with one vertex there, edges of about `size` radians and a
  /// random orientation. Evaluates its vertices.
  static Simplex around(const Rotation& start, double size, Evaluator& evaluator, Random& random);

  /// A simplex of vertices whose values are known. Each is replaced by its copy under frame_symmetries() that is
  /// nearest to the first one.
  explicit Simplex(std::array<Vertex, 4> vertices);

  /// One iteration: reflects, expands, contracts or shrinks, with one to five evaluations. Past the budget it may move
  /// vertices but cannot improve on the best one.
  void step(Evaluator& evaluator);

  /// The largest angle, in radians, between the best vertex and another one.
  double radius() const;

  const Vertex& best() const { return vertices_[0]; }
  const std::array<Vertex, 4>& vertices() const { return vertices_; }

 private:
  void sort();

  std::array<Vertex, 4> vertices_;
};

/// The copy of `rotation` under frame_symmetries() that is nearest to `reference`.
Rotation nearest_copy(const Rotation& rotation, const Rotation& reference);

/// The point at parameter `t`, any real number, on the shortest geodesic that runs from a (t = 0) through b (t = 1).
Rotation along_geodesic(const Rotation& a, const Rotation& b, double t);

}  // namespace rectilin
