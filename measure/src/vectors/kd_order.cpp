#include "vectors/kd_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "rectilin/base/ceil_div.h"
#include "tree/direction_tree_kernels.h"

namespace rectilin {
namespace {

using Places = std::vector<std::uint16_t>;

/// The stereographic projection of the run's directions, up to sign, about their mean: small squares stay squares, and
/// the hemisphere becomes a disc. Both coordinates have the same unit and run from 0 to 65535.
std::array<Places, 2> plane_coordinates(const std::vector<Vector3>& run) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& v : run) sum += v;
  const Vector3 mean = sum.stableNormalized();
  const Vector3 axes[2] = {mean.unitOrthogonal(), mean.cross(mean.unitOrthogonal())};
  std::array<std::vector<float>, 2> plane;
  for (int k = 0; k < 2; ++k) plane[k].resize(run.size());
  for (std::size_t i = 0; i < run.size(); ++i) {
    const double height = mean.dot(run[i]);
    const double size = std::copysign(run[i].norm() + std::abs(height), height);
    const double inverse = std::isnormal(size) ? 1 / size : 0;
    for (int k = 0; k < 2; ++k) plane[k][i] = static_cast<float>(axes[k].dot(run[i]) * inverse);
  }
  float least[2], extent = std::numeric_limits<float>::min();
  for (int k = 0; k < 2; ++k) {
    const auto [low, high] = std::minmax_element(plane[k].begin(), plane[k].end());
    least[k] = *low;
    extent = std::max(extent, *high - *low);
  }
  std::array<Places, 2> coordinates;
  for (int k = 0; k < 2; ++k) {
    coordinates[k].resize(run.size());
    for (std::size_t i = 0; i < run.size(); ++i)
      coordinates[k][i] = static_cast<std::uint16_t>((plane[k][i] - least[k]) / extent * 65535);
  }
  return coordinates;
}

/// The places sorted by their keys, ascending; stable.
Places sorted_places(const Places& keys) {
  Places order(keys.size()), next(keys.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  for (const int shift : {0, 8}) {
    std::array<std::size_t, 257> begins{};
    for (const std::uint16_t key : keys) ++begins[(key >> shift & 255) + 1];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    for (const std::uint16_t place : order) next[begins[keys[place] >> shift & 255]++] = place;
    order.swap(next);
  }
  return order;
}

/// Sorts once by each coordinate; halving then keeps both lists sorted.
class Halving {
 public:
  explicit Halving(std::array<Places, 2> coordinates)
      : coordinates_(std::move(coordinates)),
        sorted_{sorted_places(coordinates_[0]), sorted_places(coordinates_[1])},
        first_half_(coordinates_[0].size()),
        second_(coordinates_[0].size()) {
    halve(0, first_half_.size());
  }

  const Places& order() const { return sorted_[0]; }

 private:
  void halve(std::size_t begin, std::size_t end) {
    if (end - begin <= kLeaf) return;
    const std::size_t leaves = ceil_div(end - begin, kLeaf);
    const std::size_t middle = begin + std::bit_ceil(leaves) / 2 * kLeaf;
    const int wide = extent(0, begin, end) < extent(1, begin, end) ? 1 : 0;
    for (std::size_t i = begin; i < end; ++i) first_half_[sorted_[wide][i]] = i < middle;

    // The places of the other list are divided into halves without a branch, because no processor could predict it.
    Places& other = sorted_[1 - wide];
    std::size_t first = begin, second = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint16_t place = other[i];
      other[first] = second_[second] = place;
      first += first_half_[place];
      second += 1 - first_half_[place];
    }
    std::copy_n(second_.begin(), second, other.begin() + static_cast<std::ptrdiff_t>(middle));
    halve(begin, middle);
    halve(middle, end);
  }

  int extent(int k, std::size_t begin, std::size_t end) const {
    return coordinates_[k][sorted_[k][end - 1]] - coordinates_[k][sorted_[k][begin]];
  }

  std::array<Places, 2> coordinates_;
  std::array<Places, 2> sorted_;  // the places, sorted by each coordinate; the halves of both hold the same places
  std::vector<std::uint8_t> first_half_;  // for each place: is it in the first half?
  Places second_;
};

}  // namespace

void align(std::vector<Vector3>& run) {
  Vector3 before(0.48, 0.36, 0.8);
  for (Vector3& v : run) {
    if (before.dot(v) < 0) v = -v;
    if (!v.isZero(0)) before = v;
  }
}

void arrange(std::vector<Vector3>& run) {
  if (run.size() <= kLeaf) return;
  std::vector<Vector3> aligned = run;
  align(aligned);
  const Halving halving(plane_coordinates(aligned));
  const std::vector<Vector3> before = std::exchange(run, {});
  run.reserve(before.size());
  for (const std::uint16_t place : halving.order()) run.push_back(before[place]);
}

}  // namespace rectilin
