#include "features/ntu_features.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "features/fourier.h"
#include "features/ntu_contour.h"

namespace rectilin::retrieval {
namespace {

constexpr int kAngular = 12, kRadial = 3;

struct Middle {
  double x = 0, y = 0;
};

std::vector<Pixel> covered_pixels(const Mask& mask) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < mask.size; ++y)
    for (int x = 0; x < mask.size; ++x)
      if (mask.covered(x, y)) pixels.push_back({x, y});
  return pixels;
}

Middle middle_of(std::span<const Pixel> pixels) {
  const auto [left, right] = std::ranges::minmax(pixels, {}, &Pixel::x);
  const auto [top, bottom] = std::ranges::minmax(pixels, {}, &Pixel::y);
  return {(left.x + right.x) / 2.0, (top.y + bottom.y) / 2.0};
}

std::uint8_t cut(double x, double scale) {
  return static_cast<std::uint8_t>(std::clamp(std::floor(x * scale), 0.0, 255.0));
}

/// The transform's functions at the points of a square grid, from which the program takes those between by bilinear
/// interpolation. That shows in the bytes: functions are 0 from the radius on, and at the centre, where they have no
/// direction, those of every p are 1.
class ArtTable {
 public:
  static constexpr int kRadius = 50, kSide = 2 * kRadius + 2;  // a last row and column of zeros
  static constexpr std::size_t kFunctions = static_cast<std::size_t>(kAngular) * kRadial;
  using Values = std::array<std::complex<double>, kFunctions>;

  ArtTable() : values_(static_cast<std::size_t>(kSide) * kSide) {
    for (int y = -kRadius; y <= kRadius; ++y)
      for (int x = -kRadius; x <= kRadius; ++x) {
        const double distance = std::hypot(x, y);
        if (distance >= kRadius) continue;
        const double angle = std::atan2(y, x);
        for (int p = 0; p < kAngular; ++p)
          for (int r = 0; r < kRadial; ++r)
            values_[at(x + kRadius, y + kRadius)][static_cast<std::size_t>(p * kRadial + r)] =
                std::cos(std::numbers::pi * distance / kRadius * r) * std::polar(1.0, p * angle);
      }
  }
  static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }
  const Values& operator[](std::size_t i) const { return values_[i]; }
  std::size_t size() const { return values_.size(); }

 private:
  std::vector<Values> values_;
};

void write_art(NtuView& view, std::span<const Pixel> pixels, const Middle& middle, double radius) {
  static const ArtTable table;
  // How much of each grid point all pixels together ask for.
  std::vector<double> weights(table.size());
  const double scale = radius > 0 ? ArtTable::kRadius / radius : 0;
  for (const Pixel& p : pixels) {
    const double x = (p.x - middle.x) * scale + ArtTable::kRadius, y = (p.y - middle.y) * scale + ArtTable::kRadius;
    const int column = std::min(static_cast<int>(x), ArtTable::kSide - 2);
    const int line = std::min(static_cast<int>(y), ArtTable::kSide - 2);
    const double right = x - column, below = y - line;
    weights[ArtTable::at(column, line)] += (1 - right) * (1 - below);
    weights[ArtTable::at(column + 1, line)] += right * (1 - below);
    weights[ArtTable::at(column, line + 1)] += (1 - right) * below;
    weights[ArtTable::at(column + 1, line + 1)] += right * below;
  }
  ArtTable::Values sums{};
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0)
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weights[i] * table[i][k];
  const double first = std::abs(sums[0]);
  for (std::size_t k = 1; k < sums.size(); ++k) view.art[k - 1] = first > 0 ? cut(std::abs(sums[k]) / first, 256) : 0;
}

}  // namespace

std::array<NtuView, kCameras> ntu_features(std::span<const Mask, kCameras> silhouettes) {
  std::array<NtuView, kCameras> views;
  std::array<std::vector<Pixel>, kCameras> pixels;
  std::array<Middle, kCameras> middles;
  double radius = 0;
  for (std::size_t c = 0; c < kCameras; ++c) {
    pixels[c] = covered_pixels(silhouettes[c]);
    if (pixels[c].empty()) continue;
    middles[c] = middle_of(pixels[c]);
    for (const Pixel& p : pixels[c]) radius = std::max(radius, std::hypot(p.x - middles[c].x, p.y - middles[c].y));
  }
  for (std::size_t c = 0; c < kCameras; ++c) {
    if (pixels[c].empty()) continue;
    write_art(views[c], pixels[c], middles[c], radius);
    const std::vector<double> fourier =
        fourier_descriptors(centroid_distances(ntu_contour(silhouettes[c]), middles[c].x, middles[c].y), 10);
    for (std::size_t k = 0; k < 10; ++k) views[c].fd[k] = cut(fourier[k], 512);
    double i20 = 0, i11 = 0, i02 = 0;
    for (const Pixel& p : pixels[c]) {
      const double x = p.x - middles[c].x, y = p.y - middles[c].y;
      i20 += x * x;
      i11 += x * y;
      i02 += y * y;
    }
    const double sum = i20 + i02;
    if (sum > 0) views[c].ecc = cut(((i20 - i02) * (i20 - i02) + 4 * i11 * i11) / (sum * sum), 256);
    const double perimeter = static_cast<double>(boundary_pixels(silhouettes[c]));
    views[c].cir =
        cut(std::min(1.0, 4 * std::numbers::pi * static_cast<double>(pixels[c].size()) / (perimeter * perimeter)), 256);
  }
  return views;
}

}  // namespace rectilin::retrieval
