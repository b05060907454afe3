#include "vectors/kd_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

#include "rectilin/base/ceil_div.h"
#include "tree/direction_tree_kernels.h"
#include "vectors/order_kernels.h"

namespace rectilin {
namespace {

using Places = std::vector<std::uint16_t>;

/// The coordinates of the run's directions in a plane about their mean.
std::array<Places, 2> plane_coordinates(const VectorSpan<double>& run) {
  constexpr std::size_t kStep = 16;  // the mean of some vectors serves as well
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < run.size; i += kStep) sum += Vector3(run.x[i], run.y[i], run.z[i]);
  const Vector3 mean = sum.stableNormalized();
  const Vector3 axes[3] = {mean.unitOrthogonal(), mean.cross(mean.unitOrthogonal()), mean};
  std::array<std::array<double, 3>, 3> rows;
  for (int k = 0; k < 3; ++k) rows[k] = {axes[k].x(), axes[k].y(), axes[k].z()};
  std::vector<float> plane[2] = {std::vector<float>(run.size), std::vector<float>(run.size)};
  std::array<Places, 2> coordinates = {Places(run.size), Places(run.size)};
  project(run, rows, plane[0].data(), plane[1].data(), coordinates[0].data(), coordinates[1].data());
  return coordinates;
}

/// The places sorted by their keys, ascending; stable.
Places sorted_places(const Places& keys) {
  std::vector<std::uint32_t> items(keys.size()), next(keys.size());  // keys in the high halves, places in the low ones
  for (std::size_t i = 0; i < keys.size(); ++i) items[i] = std::uint32_t{keys[i]} << 16 | static_cast<std::uint32_t>(i);
  for (const int shift : {16, 24}) {
    std::array<std::uint32_t, 256> begins{};
    for (const std::uint32_t item : items) ++begins[item >> shift & 255];
    std::exclusive_scan(begins.begin(), begins.end(), begins.begin(), std::uint32_t{0});
    for (const std::uint32_t item : items) next[begins[item >> shift & 255]++] = item;
    items.swap(next);
  }
  Places order(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = static_cast<std::uint16_t>(items[i]);
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

std::vector<double> arranged(const VectorSpan<double>& run) {
  std::vector<double> result(3 * run.size);
  const double* components[] = {run.x, run.y, run.z};
  if (run.size <= kLeaf) {
    for (std::size_t c = 0; c < 3; ++c) std::copy_n(components[c], run.size, result.data() + c * run.size);
    return result;
  }
  const Halving halving(plane_coordinates(run));
  for (std::size_t c = 0; c < 3; ++c)
    std::ranges::transform(halving.order(), result.data() + c * run.size,
                           [&](std::uint16_t i) { return components[c][i]; });
  return result;
}

}  // namespace rectilin
