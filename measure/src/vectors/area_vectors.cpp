#include "rectilin/measure/area_vectors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "rectilin/base/ceil_div.h"
#include "rectilin/measure/direction_tree.h"
#include "vectors/hilbert_order.h"
#include "vectors/kd_order.h"

namespace rectilin {
namespace {

/// The compensated sum (Kahan 1965) of a run of parallel vectors, turned to one side, so that millions of coplanar
/// faces keep all digits of double precision.
class ParallelSum {
 public:
  explicit ParallelSum(const Vector3& first) : sum_(first), squared_(first.squaredNorm()) {}

  bool accepts(const Vector3& v) const {
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
  double length() const { return std::sqrt(squared_); }

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

/// The area vectors of the triangles (eqs. 5-7) in units of 2^exponent. Returns whether these units serve: all vectors
/// are finite, and the longest is neither so long nor so short that products of squares might overflow or lose digits.
bool find_area_vectors(const MeshView& mesh, int exponent, std::vector<Vector3>& vectors) {
  constexpr double kLeast = 0x1p-96, kMost = 0x1p96;
  const double scale = std::ldexp(1.0, -exponent / 2);  // half the exponent, applied twice: 2^-exponent might overflow
  const double rest = std::ldexp(1.0, -exponent - (-exponent / 2));
  std::atomic<bool> finite = true, long_enough = false;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vectors.size(), 4096), [&](const auto& range) {
    double largest = 0;
    bool in_range = true;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const Vector3& origin = mesh.vertices[t[0]];
      Vector3 a = mesh.vertices[t[1]] - origin, b = mesh.vertices[t[2]] - origin;
      if (exponent != 0) a = a * scale * rest, b = b * scale * rest;
      vectors[i] = 0.5 * a.cross(b);
      const double size = vectors[i].cwiseAbs().sum();
      in_range &= size <= kMost;  // false for what is not a number as well
      largest = std::max(largest, size);
    }
    if (!in_range) finite = false;
    if (largest >= kLeast) long_enough = true;
  });
  return finite && long_enough;
}

/// Reorders runs of vectors that are neighbours along the curve so that neighbours in the plane stand together. Runs
/// have a fixed length, so that the order does not depend on the number of threads.
void arrange_runs(AreaVectors& vectors) {
  tbb::parallel_for(std::size_t{0}, ceil_div(vectors.size(), kRun), [&](std::size_t part) {
    const std::size_t begin = part * kRun, end = std::min(begin + kRun, vectors.size());
    std::vector<Vector3> run;
    run.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) run.push_back(vectors[i]);
    arrange(run);
    for (std::size_t i = begin; i < end; ++i) vectors.set(i, run[i - begin]);
  });
}

/// Scales vectors that are all short to lengths of about 1, so that products of their squares do not underflow; returns
/// the exponent that undoes this.
int lengthen(std::vector<Vector3>& vectors) {
  constexpr double kShort = 0x1p-64;
  double largest = 0;
  for (const Vector3& v : vectors) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  if (!(largest > 0 && largest < kShort)) return 0;
  const int exponent = std::ilogb(largest);
  for (Vector3& v : vectors) v = v.unaryExpr([exponent](double c) { return std::ldexp(c, -exponent); });
  return exponent;
}

}  // namespace

double AreaVectors::area() const { return std::ldexp(total, exponent); }

AreaVectors area_vectors(std::vector<Vector3> vectors) {
  AreaVectors result;
  result.exponent = lengthen(vectors);
  const std::vector<std::uint32_t> order = order_by_direction(vectors);
  result.faces = order.size();
  for (AlignedDoubles* component : {&result.x, &result.y, &result.z}) component->reserve(order.size());
  const auto sorted = [&](std::size_t i) -> const Vector3& {
    constexpr std::size_t kAhead = 32;  // prefetching, because the order jumps through memory
    __builtin_prefetch(&vectors[order[std::min(i + kAhead, order.size() - 1)]]);
    return vectors[order[i]];
  };
  long double total = 0;
  for (std::size_t i = 0; i < order.size();) {
    ParallelSum sum(sorted(i));
    for (++i; i < order.size() && sum.accepts(sorted(i)); ++i) sum.add(sorted(i));
    const Vector3& v = sum.value();
    result.x.push_back(v.x());
    result.y.push_back(v.y());
    result.z.push_back(v.z());
    total += sum.length();
  }
  result.total = static_cast<double>(total);
  if (DirectionTree::worthwhile(result.size())) arrange_runs(result);  // the flat sum needs no order
  return result;
}

AreaVectors area_vectors(const MeshView& mesh) {
  int exponent = 0;
  std::vector<Vector3> vectors(mesh.triangles.size());
  if (!find_area_vectors(mesh, exponent, vectors)) {
    exponent = length_exponent(mesh);
    find_area_vectors(mesh, exponent, vectors);
    for (const Vector3& v : vectors)  // what follows compares and converts them
      if (!v.allFinite()) throw MeshError("a vertex is not finite");
  }
  AreaVectors result = area_vectors(std::move(vectors));
  result.exponent += 2 * exponent;
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
