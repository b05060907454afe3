// Depths over a triangle.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/triangle_rows.h"

namespace rectilin::render {

/// A triangle's plane: depth over the picture, kept within the depths of the corners, so that a triangle seen nearly
/// edge on does not reach further than it is. Sums and products are rounded one by one; the plane of the triangle
/// reflected in x and depth is the reflected plane, bit for bit.
struct DepthPlane {
  float z, across, down;  ///< at the corner (x, y), and by a subpixel
  float low, high;
  std::int32_t x, y;

  DepthPlane() = default;
  /// `area` is twice the area in square subpixels, with its sign.
  DepthPlane(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, const std::array<float, 3>& depths,
             std::int64_t area)
      : z(depths[0]), across(0), down(0), x(a.x), y(a.y) {
    low = std::min({depths[0], depths[1], depths[2]}), high = std::max({depths[0], depths[1], depths[2]});
    if (area == 0) return;
    const double inverse = 1 / static_cast<double>(area);
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double bz = double{depths[1]} - double{depths[0]}, cz = double{depths[2]} - double{depths[0]};
    across = static_cast<float>((bz * cy - cz * by) * inverse);
    down = static_cast<float>((cz * bx - bz * cx) * inverse);
  }

  /// On the row of pixel centres at `y_centre`, at x = that of the corner.
  float row_start(std::int32_t y_centre) const { return z + down * static_cast<float>(y_centre - y); }
  float at(float start, std::int32_t x_centre) const {
    const float depth = start + across * static_cast<float>(x_centre - x);
    return depth < low ? low : depth > high ? high : depth;
  }
};

}  // namespace rectilin::render
