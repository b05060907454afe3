// The outline of a silhouette.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace rectilin::retrieval {

/// A square picture of zeros and ones, rows from the top, with a border of zeros around it, so that neighbours may be
/// asked for without a check: pixel (x, y) is at (y + 1) * stride + x + 1.
struct Mask {
  int size = 0;
  std::vector<std::uint8_t> pixels;

  explicit Mask(int n = 0) : size(n), pixels(static_cast<std::size_t>((n + 2) * (n + 2))) {}
  int stride() const { return size + 2; }
  std::size_t at(int x, int y) const { return static_cast<std::size_t>((y + 1) * stride() + x + 1); }
  bool covered(int x, int y) const { return pixels[at(x, y)] != 0; }
};

struct Pixel {
  int x, y;
};

/// The outer boundary of the largest part (pixels connected by sides or corners; the first in reading order of equally
/// large ones): its pixels in order, once around, some of them twice where the part is one pixel thin. Empty for an
/// empty mask.
std::vector<Pixel> outer_contour(const Mask& mask);

/// The boundary of the part whose first pixel in reading order is `start` (Moore's tracing, stopped by Jacob's rule).
std::vector<Pixel> trace_from(const Mask& mask, Pixel start);

/// Covered pixels of which one of the 8 neighbours is not covered.
std::size_t boundary_pixels(const Mask& mask);

}  // namespace rectilin::retrieval
