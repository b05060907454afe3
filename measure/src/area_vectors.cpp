#include "rectilin/measure/area_vectors.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rectilin {
namespace {

using Extended = long double;  // sums of millions of coplanar faces keep double's digits

/// A fixed turn, orthonormal to the digits given, without meaning but for this: the walls of the sorting
/// cells must not pass through directions that meshes are full of, such as the coordinate axes, or
/// rounding would put equal normals on both sides of a wall.
Eigen::Matrix3d arbitrary_turn() {
  return Eigen::Quaterniond(0.61, 0.37, -0.53, 0.29).normalized().toRotationMatrix();
}

/// Spreads the low 16 bits of x to the even places.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 8)) & 0x00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

/// Place of a direction (either sign) along a Morton curve over the hemisphere, mapped to a square by the
/// hemi-octahedral projection (Cigolle et al. 2014, A Survey of Efficient Representations for
/// Independent Unit Vectors).
std::uint32_t direction_key(const Vector3& direction, const Eigen::Matrix3d& turn) {
  Vector3 d = turn * direction;
  if (d.z() < 0) d = -d;
  const double norm = std::abs(d.x()) + std::abs(d.y()) + d.z();
  const double s = (d.x() + d.y()) / norm, t = (d.x() - d.y()) / norm;  // each in [-1, 1]
  const auto quantised = [](double c) {
    return static_cast<std::uint32_t>(std::clamp((c + 1) * 32768.0, 0.0, 65535.0));
  };
  return spread_bits(quantised(s)) | (spread_bits(quantised(t)) << 1);
}

bool lexicographically_less(const Vector3& a, const Vector3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Indices of the nonzero vectors, neighbours in direction next to each other; a total order that does not
/// depend on the order of the input beyond ties.
std::vector<std::uint32_t> sorted_by_direction(const std::vector<Vector3>& vectors) {
  const Eigen::Matrix3d turn = arbitrary_turn();
  std::vector<std::uint64_t> keyed(vectors.size());  // key in the high half, index in the low one
  constexpr std::uint64_t kDropped = ~std::uint64_t{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vectors.size(), 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      keyed[i] = vectors[i].isZero(0) ? kDropped
                                      : std::uint64_t{direction_key(vectors[i], turn)} << 32 | i;
  });
  std::erase(keyed, kDropped);
  tbb::parallel_sort(keyed.begin(), keyed.end());

  std::vector<std::uint32_t> order(keyed.size());
  std::ranges::transform(keyed, order.begin(), [](std::uint64_t k) { return static_cast<std::uint32_t>(k); });
  // Vectors that share a cell: by exact direction, so that parallel ones meet.
  for (std::size_t begin = 0; begin < keyed.size();) {
    std::size_t end = begin + 1;
    while (end < keyed.size() && keyed[end] >> 32 == keyed[begin] >> 32) ++end;
    if (end - begin > 1) {
      const auto unit = [&](std::uint32_t i) -> Vector3 {
        const Vector3& v = vectors[i];
        return (turn.row(2) * v < 0 ? -v : v).normalized();
      };
      std::stable_sort(order.begin() + begin, order.begin() + end,
                       [&](std::uint32_t a, std::uint32_t b) { return lexicographically_less(unit(a), unit(b)); });
    }
    begin = end;
  }
  return order;
}

/// Sum of a run of parallel vectors, all turned to the side of the first.
class ParallelSum {
 public:
  explicit ParallelSum(const Vector3& first) : sum_(first.cast<Extended>()) {}

  bool accepts(const Vector3& v) const {
    const Vector3 s = sum_.cast<double>();
    return s.cross(v).norm() <= kParallel * s.norm() * v.norm();
  }
  void add(const Vector3& v) {
    const Eigen::Matrix<Extended, 3, 1> w = v.cast<Extended>();
    if (sum_.dot(w) < 0) sum_ -= w;
    else sum_ += w;
  }
  Vector3 value() const { return sum_.cast<double>(); }

 private:
  Eigen::Matrix<Extended, 3, 1> sum_;
};

}  // namespace

double AreaVectors::area() const { return std::ldexp(total, exponent); }

AreaVectors area_vectors(const std::vector<Vector3>& vectors) {
  AreaVectors result;
  const std::vector<std::uint32_t> order = sorted_by_direction(vectors);
  result.faces = order.size();
  Extended total = 0;
  const auto append = [&](const Vector3& v) {
    result.x.push_back(v.x());
    result.y.push_back(v.y());
    result.z.push_back(v.z());
    total += std::sqrt(v.cast<Extended>().squaredNorm());
  };
  for (std::size_t i = 0; i < order.size();) {
    ParallelSum sum(vectors[order[i]]);
    for (++i; i < order.size() && sum.accepts(vectors[order[i]]); ++i) sum.add(vectors[order[i]]);
    append(sum.value());
  }
  result.total = static_cast<double>(total);
  return result;
}

AreaVectors area_vectors(const Mesh& mesh) {
  const auto edges = [&](const Triangle& t) {
    const Vector3& origin = mesh.vertices[t[0]];
    return std::pair<Vector3, Vector3>(mesh.vertices[t[1]] - origin, mesh.vertices[t[2]] - origin);
  };
  double largest = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b] = edges(t);
    largest = std::max({largest, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double half_scale = std::ldexp(1.0, -exponent / 2);  // in two steps: 2^-exponent may overflow
  const double other_half = std::ldexp(1.0, -exponent - (-exponent / 2));

  std::vector<Vector3> vectors(mesh.triangles.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vectors.size(), 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto [a, b] = edges(mesh.triangles[i]);
      vectors[i] = 0.5 * (a * half_scale * other_half).cross(b * half_scale * other_half);  // eqs. (5)-(7)
    }
  });
  AreaVectors result = area_vectors(vectors);
  result.exponent = 2 * exponent;
  if (result.total == 0) throw MeshError("the total area is zero");
  return result;
}

}  // namespace rectilin
