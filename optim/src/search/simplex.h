// Nelder and Mead's simplex of four rotations.
#pragma once

#include <array>

#include "rectilin/base/random.h"
#include "rectilin/optim/evaluator.h"

namespace rectilin {

/// The method of Nelder and Mead (1965) carried over to rotations: the straight line from the worst
/// vertex through the centre of the others becomes the geodesic. Its vertices stay in order, the
/// best first.
class Simplex {
 public:
  struct Vertex {
    Rotation rotation;
    double value;
  };

  /// A regular simplex in the tangent space at `start`, one vertex there; edges of about `size`
  /// radians, random orientation. Evaluates its vertices.
  static Simplex around(const Rotation& start, double size, Evaluator& evaluator, Random& random);

  /// Vertices whose values are known. Copies under frame_symmetries() are replaced by those next to
  /// the first.
  explicit Simplex(std::array<Vertex, 4> vertices);

  /// One iteration: reflects, expands, contracts or shrinks. One to five evaluations; past the
  /// budget nothing changes but the vertices' places.
  void step(Evaluator& evaluator);

  /// The largest angle between the best vertex and another, radians.
  double radius() const;

  const Vertex& best() const { return vertices_[0]; }
  const std::array<Vertex, 4>& vertices() const { return vertices_; }

 private:
  void sort();

  std::array<Vertex, 4> vertices_;
};

/// The copy of `rotation` under frame_symmetries() that is nearest to `reference`.
Rotation nearest_copy(const Rotation& rotation, const Rotation& reference);

/// The point at `t` on the shortest geodesic from a (t = 0) through b (t = 1), t any real number.
Rotation along_geodesic(const Rotation& a, const Rotation& b, double t);

}  // namespace rectilin
