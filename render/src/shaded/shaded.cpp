#include "rectilin/render/shaded.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "raster/depth_plane.h"
#include "raster/triangle_rows.h"
#include "views/placed.h"

namespace rectilin::render {
namespace {

constexpr int kSamples = 3;  // per pixel, each way
constexpr std::uint32_t kBackground = ~0u;

/// Which face is in front at each sample, and how near it is.
class FaceRaster {
 public:
  FaceRaster(const Mesh& mesh, const Ball& ball, const Rotation& frame, int size)
      : grid_(size),
        face_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), kBackground),
        depth_(face_.size(), -std::numeric_limits<float>::infinity()) {
    const ToUnitBall placed(ball);
    points_.resize(mesh.vertices.size());
    std::vector<char> done(mesh.vertices.size(), 0);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      for (const auto k : t)
        if (!done[k]) {
          points_[k] = frame.matrix() * placed(mesh.vertices[k], ViewRenderer::kReach) * (size / 2.0);
          done[k] = 1;
        }
      draw(i, points_[t[0]], points_[t[1]], points_[t[2]]);
    }
  }

  /// Grey value of a sample, 0 to 1.
  double shade(int x, int y) const {
    const std::uint32_t face = face_[at(x, y)];
    if (face == kBackground) return 1;
    if (crease(x, y, x + 1, y) || crease(x, y, x, y + 1)) return 0.15;
    static const Vector3 light = Vector3(-0.3, 0.7, 0.65).normalized();
    const double lit = std::max(0.0, normals_[face].dot(light));
    return 0.35 + 0.6 * lit;
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.size) + static_cast<std::size_t>(x);
  }

  void draw(std::uint32_t face, const Vector3& a, const Vector3& b, const Vector3& c) {
    Vector3 normal = (b - a).cross(c - a).stableNormalized();
    if (normal.z() < 0) normal = -normal;
    normals_.push_back(normal);
    const auto on_grid = [](const Vector3& p) {
      return RasterPoint{static_cast<std::int32_t>(std::nearbyint(kSubpixels * p.x())),
                         static_cast<std::int32_t>(std::nearbyint(-kSubpixels * p.y()))};
    };
    const RasterPoint pa = on_grid(a), pb = on_grid(b), pc = on_grid(c);
    DepthPlane plane;
    triangle_rows<Coverage::kCentre>(
        pa, pb, pc, grid_,
        [&](std::int64_t area) {
          plane = DepthPlane(pa, pb, pc,
                             {static_cast<float>(a.z()), static_cast<float>(b.z()), static_cast<float>(c.z())}, area);
        },
        [&](int y, int first, int last) {
          const float start = plane.row_start(grid_.centre(y));
          for (int x = first; x <= last; ++x) {
            const float depth = plane.at(start, grid_.centre(x));
            if (depth <= depth_[at(x, y)]) continue;
            depth_[at(x, y)] = depth;
            face_[at(x, y)] = face;
          }
        });
  }

  /// Whether a line belongs between two neighbouring samples: the outline, an edge of 40 degrees or
  /// more, or one behind which the surface goes on further away.
  bool crease(int x, int y, int x2, int y2) const {
    if (x2 >= grid_.size || y2 >= grid_.size) return false;
    const std::uint32_t f = face_[at(x, y)], g = face_[at(x2, y2)];
    if (f == g) return false;
    if (f == kBackground || g == kBackground) return true;
    const double steepest = std::min(normals_[f].z(), normals_[g].z());
    const double step = 3 + 2 / std::max(0.05, steepest);  // a surface that is seen from the side is deep
    return normals_[f].dot(normals_[g]) < 0.77 || std::abs(depth_[at(x, y)] - depth_[at(x2, y2)]) > step * kSamples;
  }

  PixelGrid grid_;
  std::vector<std::uint32_t> face_;
  std::vector<float> depth_;               ///< in samples
  std::vector<Vector3> points_, normals_;  ///< normals: towards the viewer
};

}  // namespace

std::vector<std::uint8_t> shaded(const Mesh& mesh, const Ball& ball, const Rotation& frame, int size) {
  if (size < 1 || size > kLargestPicture / kSamples)
    throw std::invalid_argument("a shaded picture has from 1 to " + std::to_string(kLargestPicture / kSamples) +
                                " pixels in a row");
  const FaceRaster raster(mesh, ball, frame, size * kSamples);
  std::vector<std::uint8_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i)
        sum += raster.shade(x * kSamples + i % kSamples, y * kSamples + i / kSamples);
      pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * sum / (kSamples * kSamples))));
    }
  return pixels;
}

Ball ball_fitting(const Mesh& mesh, const Rotation& frame, double margin) {
  if (mesh.triangles.empty()) return {Vector3::Zero(), 0};
  const int exponent = size_exponent(mesh);
  Vector3 lower = Vector3::Constant(4), upper = -lower;
  for (const Triangle& t : mesh.triangles)
    for (const auto i : t) {
      const Vector3 p = frame.matrix() * times_power(mesh.vertices[i], -exponent);
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
  const Vector3 extent = upper - lower, centre = frame.matrix().transpose() * ((lower + upper) / 2);
  // A needle seen from its end stays within reach in depth.
  const double half = std::max({extent.x() / 2, extent.y() / 2, extent.z() / (2 * ViewRenderer::kReach - 1)});
  const double radius = std::scalbn(half / (1 - 2 * margin), exponent);
  return {times_power(centre, exponent), std::min(radius, std::numeric_limits<double>::max())};
}

}  // namespace rectilin::render
