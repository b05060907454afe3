// The pixels that a triangle covers, row by row, in whole numbers. The one rasterizer of the project: depth pictures
// and shaded ones differ in what they do with a row.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "rectilin/render/rasterizer.h"

namespace rectilin::render {

constexpr int kSubpixelBits = 8;
constexpr std::int32_t kSubpixels = 1 << kSubpixelBits;  ///< of a pixel: what corners are rounded to
constexpr std::int32_t kHalfPixel = kSubpixels / 2;

/// A corner in subpixels from the picture's centre, y down. At most 2^28 in size, so that differences of products of
/// differences fit 64 bits.
struct RasterPoint {
  std::int32_t x, y;
};

/// Where the pixels of a square picture lie: the centre of pixel i is at i * kSubpixels + first, in either direction.
struct PixelGrid {
  int size;
  std::int32_t first;

  explicit PixelGrid(int pixels) : size(pixels), first(kHalfPixel * (1 - pixels)) {}
  std::int32_t centre(int i) const { return i * kSubpixels + first; }
  /// The first and last pixel with a centre within [low - reach, high + reach]; none if first > last.
  std::array<int, 2> range(std::int32_t low, std::int32_t high, std::int32_t reach) const {
    return {std::max(0, (low - reach - first + kSubpixels - 1) >> kSubpixelBits),
            std::min(size - 1, (high + reach - first) >> kSubpixelBits)};
  }
};

namespace raster_detail {

/// floor(a / b), b > 0.
template <class Int>
Int floor_div(Int a, Int b) {
  const Int q = a / b;
  return q * b > a ? q - 1 : q;
}

/// The half plane a x + b y + c >= 0 for pixel centres x, y counted from the first pixel of the triangle's box.
template <class Int>
struct Side {
  Int a, b, c;
};

template <class Int, Coverage kRule, class Row>
void rows(const std::array<RasterPoint, 3>& p, bool flipped, const PixelGrid& grid, std::array<int, 2> columns,
          std::array<int, 2> lines, Row&& row) {
  std::array<Side<Int>, 3> sides;
  const std::int32_t x0 = grid.centre(columns[0]), y0 = grid.centre(lines[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const RasterPoint& from = p[i];
    const RasterPoint& to = p[(i + 1) % 3];
    Int dx = Int{to.x} - from.x, dy = Int{to.y} - from.y;
    if (flipped) dx = -dx, dy = -dy;
    // Positive on the inner side. A pixel's square reaches over a line if one of its corners does: half a pixel more.
    Int c = dx * (Int{y0} - from.y) - dy * (Int{x0} - from.x);
    if (kRule == Coverage::kTouched) c += ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy)) * kHalfPixel;
    sides[i] = {-dy * kSubpixels, dx * kSubpixels, c};
  }
  const int width = columns[1] - columns[0];
  for (int y = lines[0]; y <= lines[1]; ++y) {
    int left = 0, right = width;
    if (width < 6) {  // trying is cheaper than dividing
      const auto inside = [&](int x) {
        const Int e0 = sides[0].c + sides[0].a * x, e1 = sides[1].c + sides[1].a * x, e2 = sides[2].c + sides[2].a * x;
        return (e0 | e1 | e2) >= 0;
      };
      while (left <= right && !inside(left)) ++left;
      while (right > left && !inside(right)) --right;
    } else {
      for (const Side<Int>& s : sides) {
        if (s.a > 0) {
          if (s.c < 0) left = static_cast<int>(std::max<Int>(left, std::min<Int>(-floor_div(s.c, s.a), width + 1)));
        } else if (s.c < 0) {
          right = -1;
        } else if (s.a < 0) {
          right = static_cast<int>(std::min<Int>(right, s.c / -s.a));
        }
      }
    }
    if (left <= right) row(y, columns[0] + left, columns[0] + right);
    for (Side<Int>& s : sides) s.c += s.b;
  }
}

}  // namespace raster_detail

/// Calls row(y, first, last) for the pixels of each row that the triangle covers: one run each, a triangle being
/// convex. `begin` is called before the first of them, unless the triangle's box misses all pixels. Twice the area in
/// square subpixels, with its sign, is passed on to it.
template <Coverage kRule, class Begin, class Row>
void triangle_rows(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, const PixelGrid& grid,
                   Begin&& begin, Row&& row) {
  constexpr std::int32_t kReach = kRule == Coverage::kTouched ? kHalfPixel : 0;
  const std::int32_t low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
  const std::array<int, 2> lines = grid.range(low_y, high_y, kReach);
  if (lines[0] > lines[1]) return;
  const std::int32_t low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
  const std::array<int, 2> columns = grid.range(low_x, high_x, kReach);
  if (columns[0] > columns[1]) return;
  const std::int64_t area =
      (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
  if (kRule == Coverage::kCentre && area == 0) return;
  begin(area);
  // Values of a side within the triangle's box, half a pixel of reach included, are at most twice 2^14 squared.
  constexpr std::int32_t kSmall = (1 << 14) - 2 * kSubpixels;
  const bool small = high_x - low_x < kSmall && high_y - low_y < kSmall;
  const std::array<RasterPoint, 3> corners = {a, b, c};
  if (small) raster_detail::rows<std::int32_t, kRule>(corners, area < 0, grid, columns, lines, row);
  else raster_detail::rows<std::int64_t, kRule>(corners, area < 0, grid, columns, lines, row);
}

}  // namespace rectilin::render
