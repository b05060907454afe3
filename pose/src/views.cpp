#include "rectilin/pose/views.h"

#include <cstdint>
#include <vector>

#include "rectilin/render/png.h"
#include "rectilin/render/rasterizer.h"
#include "rectilin/render/shaded.h"
#include "surface.h"

namespace rectilin::pose {
namespace {

constexpr double kMargin = 1.05;  // of the ball, beyond the furthest corner

/// The view from axis k: the next axis points right, the one after it up.
Rotation view(const Rotation& frame, int k) {
  Eigen::Matrix3d rows;
  for (int j = 0; j < 3; ++j) rows.row(j) = frame.matrix().row((k + 1 + j) % 3);
  return Rotation::from_matrix(rows);
}

}  // namespace

std::array<std::string, 3> three_views(const Mesh& mesh, const Rotation& frame, int size) {
  const Surface surface = make_surface(mesh);
  const render::Ball ball{Vector3::Zero(), surface.radius * kMargin};
  std::array<std::string, 3> pictures;
  for (int k = 0; k < 3; ++k)
    pictures[static_cast<std::size_t>(k)] =
        render::grey_png(render::shaded(surface.mesh, ball, view(frame, k), size), size);
  return pictures;
}

std::array<std::string, 3> three_silhouettes(const Mesh& mesh, const Rotation& frame, int size) {
  const Surface surface = make_surface(mesh);
  render::ViewRenderer renderer(surface.mesh, {Vector3::Zero(), surface.radius * kMargin}, {.size = size});
  std::array<std::string, 3> pictures;
  for (int k = 0; k < 3; ++k) {
    const render::DepthImage image = renderer.render(view(frame, k));
    std::vector<std::uint8_t> pixels;
    for (const std::uint16_t depth : image.depth) pixels.push_back(depth == 0 ? 255 : 0);
    pictures[static_cast<std::size_t>(k)] = render::grey_png(pixels, size);
  }
  return pictures;
}

}  // namespace rectilin::pose
