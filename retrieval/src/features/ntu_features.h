// The features of the light field descriptor's own program, in its bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "features/contour.h"
#include "features/light_field.h"

namespace rectilin::retrieval {

/// Of one silhouette: what the files .art, .fd, .cir and .ecc have of it.
struct NtuView {
  std::array<std::uint8_t, 35> art{};
  std::array<std::uint8_t, 10> fd{};
  std::uint8_t cir = 0, ecc = 0;
};

/// The silhouettes of one light field, which share the radius of the angular radial transform: the largest distance in
/// any of them of a pixel from the middle of the silhouette's bounding box.
///     art  35 coefficients of MPEG-7's ART, cos(pi r rho) exp(i p theta), p = 0 ... 11, r = 0 ... 2 with r running
///          fastest, |F| / |F_00| without F_00, times 256; interpolated from a grid of 101 x 101 points
///     fd   |C_k| / |C_0|, k = 1 ... 10, of the outline's distances from that middle, times 512
///     cir  4 pi A / p^2, at most 1, times 256; ecc  ((i20-i02)^2 + 4 i11^2) / (i20+i02)^2, times 256
/// all cut off to whole numbers, at most 255. The outline is that of ntu_contour().
std::array<NtuView, kCameras> ntu_features(std::span<const Mask, kCameras> silhouettes);

}  // namespace rectilin::retrieval
