#include "features/ntu_features.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "features/fourier.h"

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

void write_art(NtuView& view, std::span<const Pixel> pixels, const Middle& middle, double radius) {
  std::array<std::complex<double>, kAngular * kRadial> sums{};
  for (const Pixel& p : pixels) {
    const double x = p.x - middle.x, y = p.y - middle.y, distance = std::hypot(x, y);
    const double rho = radius > 0 ? distance / radius : 0;
    const std::complex<double> unit = distance > 0 ? std::complex<double>(x, y) / distance : 1;
    const double wave = std::cos(std::numbers::pi * rho), radial[kRadial] = {1, wave, 2 * wave * wave - 1};
    std::complex<double> turn = 1;
    for (std::size_t a = 0; a < kAngular; ++a) {
      for (std::size_t r = 0; r < kRadial; ++r) sums[a * kRadial + r] += radial[r] * turn;
      turn = {turn.real() * unit.real() - turn.imag() * unit.imag(),
              turn.real() * unit.imag() + turn.imag() * unit.real()};
    }
  }
  for (std::size_t k = 1; k < sums.size(); ++k) view.art[k - 1] = cut(std::abs(sums[k]) / std::abs(sums[0]), 256);
}

bool in_one_part(const Mask& mask, std::size_t covered) {
  // The largest part's outline starts at its first pixel; fill from there.
  const std::vector<Pixel> outline = outer_contour(mask);
  std::vector<std::uint8_t> seen(mask.pixels.size());
  std::vector<Pixel> stack{outline.front()};
  seen[mask.at(stack[0].x, stack[0].y)] = 1;
  std::size_t count = 0;
  while (!stack.empty()) {
    const Pixel p = stack.back();
    stack.pop_back();
    ++count;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = p.x + dx, y = p.y + dy;
        if (!mask.covered(x, y) || seen[mask.at(x, y)] != 0) continue;
        seen[mask.at(x, y)] = 1;
        stack.push_back({x, y});
      }
  }
  return count == covered;
}

Mask grown(const Mask& mask) {
  Mask result(mask.size);
  for (int y = 0; y < mask.size; ++y)
    for (int x = 0; x < mask.size; ++x)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (mask.covered(x + dx, y + dy)) result.pixels[result.at(x, y)] = 1;
  return result;
}

/// Whether taking a pixel away neither parts nor joins anything: its covered neighbours, going round, are one piece
/// (Yokoi's number for 8-connected figures is one).
bool removable(const Mask& mask, int x, int y) {
  constexpr std::array<Pixel, 9> kAround{
      {{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}, {1, 0}}};
  const auto open = [&](std::size_t k) { return mask.covered(x + kAround[k].x, y + kAround[k].y) ? 0 : 1; };
  int number = 0;
  for (std::size_t k = 0; k < 8; k += 2) number += open(k) - open(k) * open(k + 1) * open(k + 2 < 8 ? k + 2 : 8);
  return number == 1;
}

/// The silhouette in one part.
Mask joined(const Mask& mask, std::size_t covered) {
  Mask result = mask;
  std::size_t count = covered;
  int steps = 0;
  while (!in_one_part(result, count)) {
    result = grown(result);
    count = static_cast<std::size_t>(std::ranges::count(result.pixels, 1));
    ++steps;
  }
  if (steps == 0) return result;
  for (bool changed = true; changed;) {  // from each side in turn, so that what stays lies in the middle
    changed = false;
    for (const Pixel side : {Pixel{0, -1}, Pixel{0, 1}, Pixel{-1, 0}, Pixel{1, 0}}) {
      const Mask before = result;
      for (int y = 0; y < mask.size; ++y)
        for (int x = 0; x < mask.size; ++x) {
          if (!result.covered(x, y) || mask.covered(x, y) || before.covered(x + side.x, y + side.y)) continue;
          if (!removable(result, x, y)) continue;
          result.pixels[result.at(x, y)] = 0;
          changed = true;
        }
    }
  }
  return result;
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
    const std::vector<Pixel> outline = outer_contour(joined(silhouettes[c], pixels[c].size()));
    const std::vector<double> fourier =
        fourier_descriptors(centroid_distances(outline, middles[c].x, middles[c].y), kCameras);
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
