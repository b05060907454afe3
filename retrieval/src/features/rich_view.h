// What a depth picture shows beside its outline's shape: slopes, directions, bends, depths, sizes.
#pragma once

#include <array>

#include "features/view_features.h"
#include "rectilin/render/rasterizer.h"

namespace rectilin::retrieval {

/// Blocks of a view's numbers, in their order.
struct RichBlock {
  const char* name;
  const char* help;
  int begin, count;
};

inline constexpr int kRichNumbers = 144;
using RichNumbers = std::array<float, kRichNumbers>;

inline constexpr std::array<RichBlock, 10> kRichBlocks{{
    {"moments", "Zernike moments of the depths", 0, kZernike},
    {"fourier", "Fourier coefficients of the outline", 35, kFourier},
    {"shape", "eccentricity and compactness", 45, 2},
    {"slope", "histogram of the angle between surface and line of sight", 47, 16},
    {"aspect", "histogram of the direction of descent, modulo a right angle, for three steepnesses", 63, 24},
    {"contour", "histogram of the outline's direction, modulo a right angle", 87, 16},
    {"bend", "histogram of the outline's turning over a short and a long way", 103, 16},
    {"depth", "histogram of the depths", 119, 16},
    {"edges", "lengths of steps in depth by direction, modulo a right angle, and in all", 135, 5},
    {"extent", "area, radius, sides of the box around the outline", 140, 4},
}};

/// Each about within [0, 1]; histograms are shares, their square roots taken by whoever keeps them. Nothing changes if
/// the picture is turned by a right angle, up to the raster: so pictures of one frame's 24 rotations can be compared
/// without knowing how they are rolled. Zeros for an empty picture.
RichNumbers rich_view_numbers(const render::DepthImage& image);

}  // namespace rectilin::retrieval
