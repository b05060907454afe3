#include "rectilin/pose/views.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rectilin/render/png.h"
#include "rectilin/render/rasterizer.h"
#include "surface.h"

namespace rectilin::pose {
namespace {

constexpr int kFiner = 3;  // pixels drawn for one shown, along an edge

/// Draws the view from axis k: the next axis points right, the one after it up.
render::DepthImage view(render::ViewRenderer& renderer, const Rotation& frame, int k) {
  Eigen::Matrix3d rows;
  for (int j = 0; j < 3; ++j) rows.row(j) = frame.matrix().row((k + 1 + j) % 3);
  return renderer.render(Rotation::from_matrix(rows));
}

/// Brightness, 0 to 1, of a drawn pixel: its slope, from the depths beside it, and its depth.
double shade(const render::DepthImage& image, int x, int y, double steps_per_pixel) {
  const auto depth = [&](int column, int row) -> double { return image.at(column, row); };
  const auto slope = [&](int dx, int dy) {
    // The gentler of both sides: across an edge to something further away there is no surface.
    double best = 1e9;
    for (const int sign : {1, -1}) {
      const int column = x + sign * dx, row = y + sign * dy;
      if (column < 0 || row < 0 || column >= image.size || row >= image.size || !image.covered(column, row)) continue;
      const double rise = sign * (depth(column, row) - depth(x, y)) / steps_per_pixel;
      if (std::abs(rise) < std::abs(best)) best = rise;
    }
    return std::clamp(best, -20.0, 20.0);
  };
  const double sx = slope(1, 0), sy = slope(0, 1), length = std::sqrt(1 + sx * sx + sy * sy);
  const double light = (0.85 + 0.3 * -sx + 0.42 * sy) / length;
  return std::clamp(0.25 + 0.45 * light + 0.25 * depth(x, y) / 65535, 0.1, 0.92);
}

template <class Brightness>
std::string picture(const render::DepthImage& image, int size, const Brightness& brightness) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double sum = 0;
      for (int i = 0; i < kFiner * kFiner; ++i) {
        const int column = x * kFiner + i % kFiner, row = y * kFiner + i / kFiner;
        sum += image.covered(column, row) ? brightness(column, row) : 1;
      }
      pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * sum / (kFiner * kFiner))));
    }
  return render::grey_png(pixels, size);
}

template <class Brightness>
std::array<std::string, 3> views(const Mesh& mesh, const Rotation& frame, int size, const Brightness& brightness) {
  const Surface surface = make_surface(mesh);
  render::ViewRenderer renderer(surface.mesh, {Vector3::Zero(), surface.radius * 1.03}, {.size = size * kFiner});
  std::array<std::string, 3> pictures;
  for (int k = 0; k < 3; ++k) {
    const render::DepthImage image = view(renderer, frame, k);
    pictures[static_cast<std::size_t>(k)] = picture(image, size, [&](int x, int y) { return brightness(image, x, y); });
  }
  return pictures;
}

}  // namespace

std::array<std::string, 3> three_views(const Mesh& mesh, const Rotation& frame, int size) {
  const double steps_per_pixel = 65534.0 / (size * kFiner);
  return views(mesh, frame, size,
               [=](const render::DepthImage& image, int x, int y) { return shade(image, x, y, steps_per_pixel); });
}

std::array<std::string, 3> three_silhouettes(const Mesh& mesh, const Rotation& frame, int size) {
  return views(mesh, frame, size, [](const render::DepthImage&, int, int) { return 0.0; });
}

}  // namespace rectilin::pose
