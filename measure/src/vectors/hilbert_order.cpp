#include "vectors/hilbert_order.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace rectilin {
namespace {

constexpr int kBits = 16;  // bits of each coordinate of a cell

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

constexpr auto kHilbertSteps = [] {
  std::array<HilbertStep, 4 * 256> steps{};
  for (unsigned i = 0; i < steps.size(); ++i) steps[i] = hilbert_step(i >> 8, i >> 4 & 15, i & 15);
  return steps;
}();

std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0, orientation = 0;
  for (int shift = kBits - 4; shift >= 0; shift -= 4) {
    const HilbertStep step = kHilbertSteps[orientation << 8 | (x >> shift & 15) << 4 | (y >> shift & 15)];
    place = place << 8 | step.place;
    orientation = step.orientation;
  }
  return place;
}

/// The hemisphere maps to a square by the hemi-octahedral projection (Cigolle et al. 2014).
std::uint32_t cell_of(const Vector3& turned) {
  constexpr double kHalf = 1 << (kBits - 1), kShortest = 1e-300;  // what is shorter weighs nothing
  const double norm = std::abs(turned.x()) + std::abs(turned.y()) + turned.z();
  const double scale = kHalf / std::max(norm, kShortest);
  const auto quantised = [scale](double c) {  // from [-norm, norm]
    return static_cast<std::uint32_t>(std::clamp(c * scale + kHalf, 0.0, 2 * kHalf - 1));
  };
  return hilbert_place(quantised(turned.x() + turned.y()), quantised(turned.x() - turned.y()));
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

/// Is every pair of these vectors, which point to one side, so nearly parallel that they will be merged?
bool all_parallel(const std::vector<Vector3>& vectors, std::span<const std::uint32_t> places) {
  const Vector3& first = vectors[places[0]];
  const double limit = 0.25 * kParallel * kParallel * first.squaredNorm();
  return std::ranges::all_of(places.subspan(1), [&](std::uint32_t place) {
    const Vector3& v = vectors[place];
    return first.cross(v).squaredNorm() <= limit * v.squaredNorm();
  });
}

/// By direction, equal ones by index.
bool lexicographically_less(const std::pair<Vector3, std::uint32_t>& a, const std::pair<Vector3, std::uint32_t>& b) {
  for (int i = 0; i < 3; ++i)
    if (a.first[i] != b.first[i]) return a.first[i] < b.first[i];
  return a.second < b.second;
}

}  // namespace

std::vector<std::uint32_t> order_by_direction(std::vector<Vector3>& vectors) {
  const Eigen::Matrix3d turn = arbitrary_turn();
  constexpr std::uint64_t kDropped = ~std::uint64_t{0};
  std::vector<std::uint64_t> items(vectors.size());  // cell in the high half, index in the low one
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vectors.size(), 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      Vector3 turned = turn * vectors[i];
      if (turned.z() < 0) turned = -turned, vectors[i] = -vectors[i];
      items[i] = vectors[i].isZero(0) ? kDropped : std::uint64_t{cell_of(turned)} << 32 | i;
    }
  });
  std::erase(items, kDropped);
  radix_sort_by_high_half(items);

  std::vector<std::uint32_t> order(items.size());
  std::ranges::transform(items, order.begin(), [](std::uint64_t item) { return static_cast<std::uint32_t>(item); });
  const auto cell = [&](std::size_t place) { return items[place] >> 32; };
  std::vector<std::pair<Vector3, std::uint32_t>> exact;  // unit vectors and indices of one cell
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    for (end = begin + 1; end < order.size() && cell(end) == cell(begin);) ++end;
    if (end - begin == 1 || all_parallel(vectors, std::span(order).subspan(begin, end - begin))) continue;
    exact.clear();
    for (std::size_t place = begin; place < end; ++place)
      exact.emplace_back(vectors[order[place]].normalized(), order[place]);
    std::ranges::sort(exact, lexicographically_less);
    for (std::size_t place = begin; place < end; ++place) order[place] = exact[place - begin].second;
  }
  return order;
}

}  // namespace rectilin
