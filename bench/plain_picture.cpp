#include "plain_picture.h"

#include <algorithm>
#include <cmath>

namespace rectilin::bench {

using render::Ball;
using render::DepthImage;

DepthImage plain_picture(const Mesh& mesh, const Ball& ball, const Rotation& frame, int size) {
  DepthImage image{size,
                   std::vector<std::uint16_t>(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0)};
  std::vector<Vector3> points;
  for (const Vector3& p : mesh.vertices) {
    const Vector3 q = frame.matrix() * (p - ball.centre) / ball.radius;
    points.emplace_back((q.x() + 1) * size / 2, (1 - q.y()) * size / 2, 32768 + 32767 * q.z());
  }
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vector3 &a = points[ia], &b = points[ib], &c = points[ic];
    const auto side = [](const Vector3& p, const Vector3& q, double x, double y) {
      return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
    };
    const double area = side(a, b, c.x(), c.y());
    if (area == 0) continue;
    const int left = std::max(0, static_cast<int>(std::ceil(std::min({a.x(), b.x(), c.x()}) - 0.5)));
    const int right = std::min(size - 1, static_cast<int>(std::floor(std::max({a.x(), b.x(), c.x()}) - 0.5)));
    const int top = std::max(0, static_cast<int>(std::ceil(std::min({a.y(), b.y(), c.y()}) - 0.5)));
    const int bottom = std::min(size - 1, static_cast<int>(std::floor(std::max({a.y(), b.y(), c.y()}) - 0.5)));
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const double wa = side(b, c, x + 0.5, y + 0.5) / area, wb = side(c, a, x + 0.5, y + 0.5) / area;
        const double wc = 1 - wa - wb;
        if (wa < 0 || wb < 0 || wc < 0) continue;
        std::uint16_t& pixel = image.depth[static_cast<std::size_t>(y * size + x)];
        pixel = std::max(pixel, static_cast<std::uint16_t>(wa * a.z() + wb * b.z() + wc * c.z()));
      }
  }
  return image;
}

}  // namespace rectilin::bench
