#include "vectors/hilbert_order.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "vectors/cell_kernels.h"

namespace rectilin {
namespace {

/// An arbitrary fixed rotation. Borders between cells, and the rim of the hemisphere, must not pass through
/// directions that are common in meshes, such as the coordinate axes, or rounding would put equal normals on both
/// sides of a border.
Eigen::Matrix3d arbitrary_turn() { return Eigen::Quaterniond(0.61, 0.37, -0.53, 0.29).normalized().toRotationMatrix(); }

/// Four levels of the Hilbert curve (Hilbert 1891) at once: the position of a sub-cell among 256, and the orientation
/// of the curve in it. Bit 0 of an orientation: mirrored in both coordinates; bit 1: coordinates swapped.
struct HilbertStep {
  std::uint8_t place, orientation;
};

constexpr HilbertStep hilbert_step(unsigned orientation, unsigned x, unsigned y) {
  unsigned place = 0;
  for (int bit = 3; bit >= 0; --bit) {
    const unsigned mirror = orientation & 1;
    unsigned right = (x >> bit & 1) ^ mirror, up = (y >> bit & 1) ^ mirror;
    if (orientation & 2) std::swap(right, up);
    place = place << 2 | ((3 * right) ^ up);
    if (!up) orientation ^= right ? 3 : 2;  // in the lower quadrants the curve is turned
  }
  return {static_cast<std::uint8_t>(place), static_cast<std::uint8_t>(orientation)};
}

const CellMap& cell_map() {
  static const CellMap map = [] {
    CellMap result;
    const Eigen::Matrix3d turn = arbitrary_turn();
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) result.rows[k][c] = turn(k, c);
    for (unsigned i = 0; i < result.curve.size(); ++i) {
      const HilbertStep step = hilbert_step(i >> 8, i >> 4 & 15, i & 15);
      result.curve[i] = step.orientation << 8 | step.place;
    }
    return result;
  }();
  return map;
}

/// A stable sort by the high half of each item. Radix sort, least significant digit first: several times faster
/// than comparing. The counts of long digits would take longer than the sorting of few items.
void radix_sort_by_high_half(std::vector<std::uint64_t>& items) {
  const int bits = items.size() < 10'000 ? 8 : 11, passes = (32 + bits - 1) / bits;
  const std::size_t buckets = std::size_t{1} << bits;
  const auto digit = [&](std::uint64_t item, int pass) { return (item >> (32 + bits * pass)) & (buckets - 1); };
  std::vector<std::uint32_t> begins(static_cast<std::size_t>(passes) * buckets);
  for (const std::uint64_t item : items)
    for (int pass = 0; pass < passes; ++pass) ++begins[static_cast<std::size_t>(pass) * buckets + digit(item, pass)];
  std::vector<std::uint64_t> target(items.size());
  for (int pass = 0; pass < passes; ++pass) {
    const std::span<std::uint32_t> begin(&begins[static_cast<std::size_t>(pass) * buckets], buckets);
    std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), std::uint32_t{0});
    for (const std::uint64_t item : items) target[begin[digit(item, pass)]++] = item;
    items.swap(target);
  }
}

/// By direction, equal ones by index.
bool lexicographically_less(const std::pair<Vector3, std::uint32_t>& a, const std::pair<Vector3, std::uint32_t>& b) {
  for (int i = 0; i < 3; ++i)
    if (a.first[i] != b.first[i]) return a.first[i] < b.first[i];
  return a.second < b.second;
}

}  // namespace

std::vector<OrderedVector> order_by_direction(std::vector<Vector3>& vectors) {
  const CellMap& map = cell_map();
  std::vector<OrderedVector> items(vectors.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vectors.size(), 4096), [&](const auto& range) {
    find_cells(map, vectors.front().data(), range.begin(), range.end(), items.data());
  });
  std::erase(items, kDropped);
  radix_sort_by_high_half(items);
  return items;
}

void sort_cell(const std::vector<Vector3>& vectors, std::span<OrderedVector> members) {
  std::vector<std::pair<Vector3, std::uint32_t>> exact;  // unit vectors and indices
  exact.reserve(members.size());
  for (const OrderedVector v : members) exact.emplace_back(vectors[index(v)].normalized(), index(v));
  std::ranges::sort(exact, lexicographically_less);
  for (std::size_t i = 0; i < members.size(); ++i) members[i] = cell(members[i]) << 32 | exact[i].second;
}

}  // namespace rectilin
