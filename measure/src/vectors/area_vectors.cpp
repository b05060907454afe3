#include "rectilin/measure/area_vectors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "vectors/hilbert_order.h"

namespace rectilin {
namespace {

/// The compensated sum (Kahan 1965) of a run of parallel vectors, turned to one side, so that millions of coplanar
/// faces keep all digits of double precision.
class ParallelSum {
 public:
  explicit ParallelSum(const Vector3& first) : sum_(first), squared_(first.squaredNorm()) {}

  [[gnu::always_inline]] bool accepts(const Vector3& v) const {
    return sum_.cross(v).squaredNorm() <= kParallel * kParallel * squared_ * v.squaredNorm();
  }
  void add(const Vector3& v) {
    const Vector3 next = v - lost_;
    const Vector3 sum = sum_ + next;
    lost_ = (sum - sum_) - next;
    sum_ = sum;
    squared_ = sum.squaredNorm();
  }
  const Vector3& value() const { return sum_; }

 private:
  Vector3 sum_, lost_ = Vector3::Zero();
  double squared_;
};

/// The exponent of the unit of length: the largest extent of a triangle along an axis, rounded up to a power of two.
int length_exponent(const MeshView& mesh) {
  double largest = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3& origin = mesh.vertices[t[0]];
    largest = std::max({largest, (mesh.vertices[t[1]] - origin).cwiseAbs().maxCoeff(),
                        (mesh.vertices[t[2]] - origin).cwiseAbs().maxCoeff()});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

/// The area vectors of triangles (eqs. 5-7). Written out, because compilers keep Eigen's vectors in memory here.
void find_area_vectors(const MeshView& mesh, std::size_t begin, std::size_t end, Vector3* vectors) {
  const Triangle* triangles = mesh.triangles.data();
  const double* vertices = mesh.vertices.data()->data();
  for (std::size_t i = begin; i < end; ++i) {
    const double* p = vertices + 3 * std::size_t{triangles[i][0]};
    const double* q = vertices + 3 * std::size_t{triangles[i][1]};
    const double* r = vertices + 3 * std::size_t{triangles[i][2]};
    const double ax = q[0] - p[0], ay = q[1] - p[1], az = q[2] - p[2];
    const double bx = r[0] - p[0], by = r[1] - p[1], bz = r[2] - p[2];
    vectors[i] = {0.5 * (ay * bz - az * by), 0.5 * (az * bx - ax * bz), 0.5 * (ax * by - ay * bx)};
  }
}

/// The same in units of 2^exponent.
void find_scaled_area_vectors(const MeshView& mesh, int exponent, std::vector<Vector3>& vectors) {
  const double scale = std::ldexp(1.0, -exponent / 2);  // half the exponent, applied twice: 2^-exponent might overflow
  const double rest = std::ldexp(1.0, -exponent - (-exponent / 2));
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vector3& origin = mesh.vertices[t[0]];
    const Vector3 a = (mesh.vertices[t[1]] - origin) * scale * rest, b = (mesh.vertices[t[2]] - origin) * scale * rest;
    vectors[i] = 0.5 * a.cross(b);
  }
}

/// Scales vectors such that the longest has a length of about 1, so that products of squares neither overflow nor
/// vanish; returns the exponent that undoes this.
int rescale(std::vector<Vector3>& vectors) {
  double largest = 0;
  for (const Vector3& v : vectors) {
    if (!v.allFinite()) throw MeshError("a vector is not finite");
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
  }
  if (largest == 0) return 0;
  const int exponent = std::ilogb(largest);
  for (Vector3& v : vectors) v = v.unaryExpr([exponent](double c) { return std::ldexp(c, -exponent); });
  return exponent;
}

/// Where the next merged vector is written: an output iterator, so that compilers keep it in registers.
struct Output {
  double *x, *y, *z;

  void write(const Vector3& v) { *x++ = v.x(), *y++ = v.y(), *z++ = v.z(); }
};

/// Adds up those that are parallel among the vectors of a cell.
class CellMerger {
 public:
  explicit CellMerger(const std::vector<Vector3>& vectors) : vectors_(vectors) {}

  /// Writes the sums; returns where the next ones go. Most cells hold one direction only. The members of others are
  /// sorted by direction first, and each is compared with its neighbour alone, so that crowded cells do not take long.
  Output merge(std::span<const OrderedVector> cell, Output out) {
    ParallelSum sum(vectors_[index(cell[0])]);
    for (const OrderedVector member : cell.subspan(1)) {
      const Vector3& v = vectors_[index(member)];
      if (!sum.accepts(v)) return merge_sorted(cell, out);
      sum.add(v);
    }
    out.write(sum.value());
    return out;
  }

 private:
  /// Neighbours in a cell that have one direction. The first component mostly settles the order of two runs.
  struct Run {
    double x;
    std::uint32_t begin, end;
  };

  /// Not inlined, to leave the registers to the common case.
  [[gnu::noinline]] Output merge_sorted(std::span<const OrderedVector> cell, Output out) {
    directions_.resize(std::max(directions_.size(), cell.size()));
    runs_.clear();
    for (std::uint32_t i = 0; i < cell.size(); ++i) {
      directions_[i] = vectors_[index(cell[i])].normalized();
      if (i > 0 && directions_[i] == directions_[i - 1]) ++runs_.back().end;
      else runs_.push_back({directions_[i].x(), i, i + 1});
    }
    std::ranges::sort(runs_, [&](const Run& a, const Run& b) {
      if (a.x != b.x) return a.x < b.x;
      const Vector3 &v = directions_[a.begin], &w = directions_[b.begin];
      return std::tie(v.y(), v.z(), a.begin) < std::tie(w.y(), w.z(), b.begin);
    });
    ParallelSum sum(vectors_[index(cell[runs_[0].begin++])]);
    for (const Run& run : runs_)
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        const Vector3& v = vectors_[index(cell[i])];
        if (sum.accepts(v)) {
          sum.add(v);
        } else {
          out.write(sum.value());
          sum = ParallelSum(v);
        }
      }
    out.write(sum.value());
    return out;
  }

  const std::vector<Vector3>& vectors_;
  std::vector<Vector3> directions_;
  std::vector<Run> runs_;
};

/// The sum of lengths, in extended precision where there is one. Roots are found by twos, and few at a time, so that a
/// processor adds up some while it finds the next.
double total_length(const AreaVectors& vectors) {
  constexpr int kBlock = 8;
  using Block = Eigen::Array<double, kBlock, 1>;
  long double total = 0;
  std::size_t i = 0;
  for (; i + kBlock <= vectors.size(); i += kBlock) {
    const auto squares = [&](const AlignedDoubles& c) { return Eigen::Map<const Block>(&c[i]).square(); };
    const Block lengths = (squares(vectors.x) + squares(vectors.y) + squares(vectors.z)).sqrt();
    for (const double length : lengths) total += length;
  }
  for (; i < vectors.size(); ++i) total += vectors[i].norm();
  return static_cast<double>(total);
}

/// Adds up those that are parallel among the vectors of each cell.
AreaVectors merge(const std::vector<Vector3>& vectors, std::span<const OrderedVector> order) {
  AreaVectors result;
  result.faces = order.size();
  AlignedDoubles* const components[] = {&result.x, &result.y, &result.z};
  for (AlignedDoubles* component : components) component->resize(order.size());
  Output out{result.x.data(), result.y.data(), result.z.data()};
  CellMerger merger(vectors);
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    do {
      // Requested into the second-level cache, because the order jumps through memory: a core can wait for more lines
      // of that than of the first.
      constexpr std::size_t kAhead = 64;
      constexpr int kSecondLevel = 2;
      const Vector3& ahead = vectors[index(order[std::min(end + kAhead, order.size() - 1)])];
      __builtin_prefetch(ahead.data(), 0, kSecondLevel);
      __builtin_prefetch(ahead.data() + 2, 0, kSecondLevel);
    } while (++end < order.size() && cell(order[end]) == cell(order[i]));
    if (end - i == 1) out.write(vectors[index(order[i])]);
    else out = merger.merge(order.subspan(i, end - i), out);
  }
  const auto size = static_cast<std::size_t>(out.x - result.x.data());
  for (AlignedDoubles* component : components) component->resize(size);
  result.total = total_length(result);
  return result;
}

}  // namespace

double AreaVectors::area() const { return std::ldexp(total, exponent); }

AreaVectors area_vectors(std::vector<Vector3> vectors) {
  DirectionOrder order = order_by_direction(vectors);
  int exponent = 0;
  if (!order.safe) {
    exponent = rescale(vectors);
    order = order_by_direction(vectors);
  }
  AreaVectors result = merge(vectors, order.vectors);
  result.exponent = exponent;
  return result;
}

AreaVectors area_vectors(const MeshView& mesh) {
  std::vector<Vector3> vectors(mesh.triangles.size());
  const auto make = [&](std::size_t begin, std::size_t end) { find_area_vectors(mesh, begin, end, vectors.data()); };
  AreaVectors result;
  if (const DirectionOrder order = order_by_direction(vectors, make); order.safe) {
    result = merge(vectors, order.vectors);
  } else {
    const int exponent = length_exponent(mesh);
    find_scaled_area_vectors(mesh, exponent, vectors);
    for (const Vector3& v : vectors)
      if (!v.allFinite()) throw MeshError("a vertex is not finite");
    result = area_vectors(std::move(vectors));
    result.exponent += 2 * exponent;
  }
  if (result.total == 0) throw MeshError("the total area is zero");
  return result;
}

AreaVectors area_vectors_of_normals(std::span<const Vector3> normals, std::span<const double> weights) {
  if (!weights.empty() && weights.size() != normals.size())
    throw MeshError("there are " + std::to_string(normals.size()) + " normals and " + std::to_string(weights.size()) +
                    " weights");
  double heaviest = weights.empty() ? 1 : 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(std::isfinite(weights[i]) && weights[i] >= 0))
      throw MeshError("weight " + std::to_string(i) + " is negative or not finite");
    heaviest = std::max(heaviest, weights[i]);
  }
  if (normals.empty() || heaviest == 0) throw MeshError("the normals have no weight");
  const int exponent = std::ilogb(heaviest);
  std::vector<Vector3> vectors(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (!normals[i].allFinite() || normals[i].isZero(0))
      throw MeshError("normal " + std::to_string(i) + " is zero or not finite");
    vectors[i] = normals[i].stableNormalized() * (weights.empty() ? 1 : std::ldexp(weights[i], -exponent));
  }
  AreaVectors result = area_vectors(std::move(vectors));
  result.exponent += exponent;
  return result;
}

AreaVectors rotated(const AreaVectors& vectors, const Rotation& rotation) {
  AreaVectors result = vectors;
  for (std::size_t i = 0; i < vectors.size(); ++i) result.set(i, rotation.matrix() * vectors[i]);
  return result;
}

}  // namespace rectilin
