#include "vectors/hilbert_order.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "vectors/order_kernels.h"

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

/// A stable sort by cell. Radix sort, least significant digit first: several times faster than comparing. Returns
/// `items` or `other`, of the same size, whichever holds the result.
template <int kDigit>
std::span<OrderedVector> radix_sort(std::span<OrderedVector> items, std::span<OrderedVector> other) {
  constexpr int kPasses = (32 + kDigit - 1) / kDigit;
  constexpr std::size_t kBuckets = std::size_t{1} << kDigit;
  const auto digit = [](OrderedVector item, int pass) { return (item >> (32 + kDigit * pass)) & (kBuckets - 1); };
  std::array<std::array<std::uint32_t, kBuckets>, kPasses> begins{};
  for (const OrderedVector item : items)
    for (int pass = 0; pass < kPasses; ++pass) ++begins[pass][digit(item, pass)];
#pragma GCC unroll 4  // each pass has its own fixed shift
  for (int pass = 0; pass < kPasses; ++pass) {
    std::exclusive_scan(begins[pass].begin(), begins[pass].end(), begins[pass].begin(), std::uint32_t{0});
    for (const OrderedVector item : items) other[begins[pass][digit(item, pass)]++] = item;
    std::swap(items, other);
  }
  return items;
}

}  // namespace

DirectionOrder order_by_direction(std::vector<Vector3>& vectors, const MakeVectors& make) {
  const CellMap& map = cell_map();
  const std::size_t size = vectors.size();
  auto memory = std::make_unique_for_overwrite<OrderedVector[]>(2 * size);
  std::span<OrderedVector> items(memory.get(), size);
  std::atomic<bool> none_above = true, some_counts = false;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, 4096), [&](const auto& range) {
    constexpr std::size_t kBlock = 512;  // vectors that stay in the nearest cache until they have a cell
    for (std::size_t begin = range.begin(); begin < range.end(); begin += kBlock) {
      const std::size_t end = std::min(begin + kBlock, range.end());
      if (make) make(begin, end);
      const SizeRange sizes = find_cells(map, vectors.front().data(), begin, end, items.data());
      if (!sizes.none_above) none_above = false;
      if (sizes.some_counts) some_counts = true;
    }
  });
  const std::span<OrderedVector> other(memory.get() + size, size);
  constexpr std::size_t kFew = 5000;  // the counts of longer digits would take longer than the sorting itself
  items = size < kFew ? radix_sort<8>(items, other) : radix_sort<11>(items, other);
  auto last = items.end();  // those that are dropped are in the last cell
  while (last != items.begin() && cell(last[-1]) == cell(kDropped)) --last;
  items = items.first(static_cast<std::size_t>(std::remove(last, items.end(), kDropped) - items.begin()));
  return {std::move(memory), items, none_above && some_counts};
}

}  // namespace rectilin
