#include "rectilin/render/thumbnail.h"

#include <png.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rectilin::render {
namespace {

constexpr int kPixels = 280;               // twice what is shown, for print and fine screens
constexpr int kSamples = 3;                // per pixel, each way
constexpr int kSize = kPixels * kSamples;  // of the raster
constexpr double kMargin = 0.03;           // of the picture, on each side
constexpr std::uint32_t kBackground = ~0u;

/// Rows are the picture's right, up and towards the viewer.
Eigen::Matrix3d view(Up up) {
  const Vector3 upward = up == Up::kY ? Vector3::UnitY() : Vector3::UnitZ();
  const Vector3 viewer = up == Up::kY ? Vector3(0.45, 0.4, 0.8) : Vector3(0.45, -0.8, 0.4);
  Eigen::Matrix3d rows;
  rows.row(2) = viewer.normalized();
  rows.row(0) = upward.cross(viewer).normalized();
  rows.row(1) = rows.row(2).cross(rows.row(0));
  return rows;
}

/// Which face is in front at each sample, and how near it is.
class Raster {
 public:
  Raster(const Mesh& mesh, Up up)
      : face_(kSize * kSize, kBackground), depth_(kSize * kSize, -std::numeric_limits<double>::infinity()) {
    const std::vector<Vector3> points = placed(mesh, view(up));
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      draw(i, points[t[0]], points[t[1]], points[t[2]]);
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
  static std::size_t at(int x, int y) { return static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x); }

  /// Vertices in samples, centred and as large as fits. y goes down.
  static std::vector<Vector3> placed(const Mesh& mesh, const Eigen::Matrix3d& view) {
    double size = 1e-300;  // coordinates may be too large to be added up
    for (const Vector3& p : mesh.vertices) size = std::max(size, p.lpNorm<Eigen::Infinity>());
    std::vector<Vector3> points(mesh.vertices.size(), Vector3::Zero());
    Vector3 lower = Vector3::Constant(2), upper = -lower;
    for (const Triangle& t : mesh.triangles)
      for (const auto i : t) {
        points[i] = view * (mesh.vertices[i] / size);
        lower = lower.cwiseMin(points[i]);
        upper = upper.cwiseMax(points[i]);
      }
    const double extent = std::max({upper.x() - lower.x(), upper.y() - lower.y(), 1e-300});
    const double scale = kSize * (1 - 2 * kMargin) / extent;
    const Vector3 centre = (lower + upper) / 2;
    for (Vector3& p : points) {
      p = scale * (p - centre);
      p = {p.x() + kSize / 2.0, kSize / 2.0 - p.y(), p.z()};
    }
    return points;
  }

  void draw(std::uint32_t face, const Vector3& a, const Vector3& b, const Vector3& c) {
    Vector3 normal = (b - a).cross(c - a);
    normals_.push_back(Vector3(normal.x(), -normal.y(), normal.z()).stableNormalized());
    if (normals_.back().z() < 0) normals_.back() *= -1;
    if (normal.z() == 0) return;  // seen edge on
    const auto range = [](double p, double q, double r) {
      return std::array{std::max(0, static_cast<int>(std::ceil(std::min({p, q, r}) - 0.5))),
                        std::min(kSize - 1, static_cast<int>(std::floor(std::max({p, q, r}) - 0.5)))};
    };
    const auto [left, right] = range(a.x(), b.x(), c.x());
    const auto [top, bottom] = range(a.y(), b.y(), c.y());
    const auto side = [](const Vector3& p, const Vector3& q, double x, double y) {
      return (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
    };
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const double u = x + 0.5, v = y + 0.5;
        const double wa = side(b, c, u, v) / normal.z(), wb = side(c, a, u, v) / normal.z(), wc = 1 - wa - wb;
        if (wa < 0 || wb < 0 || wc < 0) continue;
        const double z = wa * a.z() + wb * b.z() + wc * c.z();
        if (z <= depth_[at(x, y)]) continue;
        depth_[at(x, y)] = z;
        face_[at(x, y)] = face;
      }
  }

  /// Whether a line belongs between two neighbouring samples: the outline, an edge of 40 degrees or
  /// more, or one behind which the surface goes on further away.
  bool crease(int x, int y, int x2, int y2) const {
    if (x2 >= kSize || y2 >= kSize) return false;
    const std::uint32_t f = face_[at(x, y)], g = face_[at(x2, y2)];
    if (f == g) return false;
    if (f == kBackground || g == kBackground) return true;
    const double steepest = std::min(normals_[f].z(), normals_[g].z());
    const double step = 3 + 2 / std::max(0.05, steepest);  // a surface that is seen from the side is deep
    return normals_[f].dot(normals_[g]) < 0.77 || std::abs(depth_[at(x, y)] - depth_[at(x2, y2)]) > step * 3;
  }

  std::vector<std::uint32_t> face_;
  std::vector<double> depth_;
  std::vector<Vector3> normals_;  ///< towards the viewer
};

}  // namespace

std::string thumbnail(const Mesh& mesh, Up up) {
  const Raster raster(mesh, up);
  std::vector<png_byte> pixels;
  for (int y = 0; y < kPixels; ++y)
    for (int x = 0; x < kPixels; ++x) {
      double sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i)
        sum += raster.shade(x * kSamples + i % kSamples, y * kSamples + i / kSamples);
      pixels.push_back(static_cast<png_byte>(std::lround(255 * sum / (kSamples * kSamples))));
    }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = kPixels;
  image.format = PNG_FORMAT_GRAY;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(bytes, '\0');
  if (!png_image_write_to_memory(&image, file.data(), &bytes, 0, pixels.data(), 0, nullptr))
    throw std::runtime_error(std::string("libpng: ") + image.message);
  file.resize(bytes);
  return file;
}

}  // namespace rectilin::render
