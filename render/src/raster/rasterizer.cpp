#include "rectilin/render/rasterizer.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "raster/depth_plane.h"
#include "raster/triangle_rows.h"
#include "views/placed.h"

namespace rectilin::render {
namespace {

constexpr float kSteps = 32767;               // of depth, from the middle plane to either end
constexpr std::int16_t kNothing = INT16_MIN;  // background while drawing
constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Rounds to the nearest whole number, ties to even: in single precision, numbers about 1.5 * 2^23 are whole. Exact,
/// and the same on every machine that adds as IEEE 754 has it.
inline std::int32_t rounded(float z) {
  constexpr float kWhole = 12582912;
  return std::bit_cast<std::int32_t>(z + kWhole) - std::bit_cast<std::int32_t>(kWhole);
}

}  // namespace

std::size_t DepthImage::covered_pixels() const {
  return depth.size() - static_cast<std::size_t>(std::count(depth.begin(), depth.end(), 0));
}

ViewRenderer::ViewRenderer(const Mesh& mesh, const Ball& ball, const RenderOptions& options) : options_(options) {
  if (options.size < 1 || options.size > kLargestPicture)
    throw std::invalid_argument("a picture has from 1 to " + std::to_string(kLargestPicture) + " pixels in a row");
  const ToUnitBall placed(ball);
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  std::vector<std::uint32_t> used;
  triangles_.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    Triangle corners;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& n = number[t[i]];
      if (n == kNone) {
        n = static_cast<std::uint32_t>(used.size());
        used.push_back(t[i]);
      }
      corners[i] = n;
    }
    triangles_.push_back(corners);
  }

  const std::size_t n = used.size();
  points_.resize(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 p = placed(mesh.vertices[used[i]], kReach);
    for (std::size_t k = 0; k < 3; ++k) points_[k * n + i] = p[static_cast<Eigen::Index>(k)];
  }
  corners_.resize(n);
  const auto pixels = static_cast<std::size_t>(options.size) * static_cast<std::size_t>(options.size);
  front_.resize(pixels);
}

void ViewRenderer::project(const Rotation& frame) {
  const Eigen::Matrix3d& m = frame.matrix();
  const double to_subpixels = options_.size * double{kHalfPixel};
  const std::size_t n = corners_.size();
  const double* x = points_.data();
  const double* y = x + n;
  const double* z = y + n;
  // Adding 1.5 * 2^52 rounds to a whole number, ties to even, and the sum's low bits are that number.
  constexpr double kWhole = 6755399441055744;
  const double r0 = m(0, 0) * to_subpixels, r1 = m(0, 1) * to_subpixels, r2 = m(0, 2) * to_subpixels;
  const double u0 = -m(1, 0) * to_subpixels, u1 = -m(1, 1) * to_subpixels, u2 = -m(1, 2) * to_subpixels;
  const double t0 = m(2, 0) * kSteps, t1 = m(2, 1) * kSteps, t2 = m(2, 2) * kSteps;
  for (std::size_t i = 0; i < n; ++i) {
    const double right = r0 * x[i] + r1 * y[i] + r2 * z[i], down = u0 * x[i] + u1 * y[i] + u2 * z[i];
    const double towards = t0 * x[i] + t1 * y[i] + t2 * z[i];
    corners_[i] = {static_cast<std::int32_t>(std::bit_cast<std::int64_t>(right + kWhole)),
                   static_cast<std::int32_t>(std::bit_cast<std::int64_t>(down + kWhole)), static_cast<float>(towards)};
  }
}

template <bool kBoth, Coverage kRule>
void ViewRenderer::draw_all() {
  const PixelGrid grid(options_.size);
  const auto width = static_cast<std::size_t>(options_.size);
  for (const Triangle& t : triangles_) {
    const Corner &a = corners_[t[0]], &b = corners_[t[1]], &c = corners_[t[2]];
    const RasterPoint pa{a.x, a.y}, pb{b.x, b.y}, pc{c.x, c.y};
    DepthPlane plane;
    triangle_rows<kRule>(
        pa, pb, pc, grid,
        [&](std::int64_t area) {
          plane = DepthPlane(pa, pb, pc, {a.z, b.z, c.z}, area);
          // Within the range of depths, so that whole numbers of 16 bits hold them.
          plane.low = std::clamp(plane.low, -kSteps, kSteps), plane.high = std::clamp(plane.high, -kSteps, kSteps);
        },
        [&](int y, int first, int last) {
          const float start = plane.row_start(grid.centre(y));
          const std::int32_t x = grid.centre(first);
          std::int16_t* front = front_.data() + static_cast<std::size_t>(y) * width + first;
          std::int16_t* back = kBoth ? back_.data() + static_cast<std::size_t>(y) * width + first : nullptr;
          for (int i = 0; i <= last - first; ++i) {
            const auto depth = static_cast<std::int16_t>(rounded(plane.at(start, x + i * kSubpixels)));
            front[i] = std::max(front[i], depth);
            if (kBoth) back[i] = std::max(back[i], static_cast<std::int16_t>(-depth));
          }
        });
  }
}

template <bool kBoth>
void ViewRenderer::draw() {
  std::fill(front_.begin(), front_.end(), kNothing);
  if (kBoth) back_.assign(front_.size(), kNothing);
  if (options_.coverage == Coverage::kCentre) draw_all<kBoth, Coverage::kCentre>();
  else draw_all<kBoth, Coverage::kTouched>();
}

void ViewRenderer::copy(const std::vector<std::int16_t>& plane, bool mirrored, DepthImage& image) const {
  image.size = options_.size;
  image.depth.resize(plane.size());
  const auto width = static_cast<std::size_t>(options_.size);
  const auto from_zero = [](std::int16_t depth) { return static_cast<std::uint16_t>(depth - kNothing); };
  for (std::size_t row = 0; row < plane.size(); row += width) {
    const auto first = plane.begin() + static_cast<std::ptrdiff_t>(row);
    const auto end = first + options_.size;
    const auto to = image.depth.begin() + static_cast<std::ptrdiff_t>(row);
    if (mirrored) std::transform(std::reverse_iterator(end), std::reverse_iterator(first), to, from_zero);
    else std::transform(first, end, to, from_zero);
  }
}

DepthImage ViewRenderer::render(const Rotation& frame) {
  DepthImage image;
  project(frame);
  draw<false>();
  copy(front_, false, image);
  return image;
}

void ViewRenderer::render_both(const Rotation& frame, DepthImage& front, DepthImage& back) {
  project(frame);
  draw<true>();
  copy(front_, false, front);
  copy(back_, true, back);
}

std::pair<DepthImage, DepthImage> ViewRenderer::render_both(const Rotation& frame) {
  std::pair<DepthImage, DepthImage> images;
  render_both(frame, images.first, images.second);
  return images;
}

namespace {

/// Calls draw(renderer, k) for one direction k of each pair of opposites.
template <class Draw>
void for_each_pair(const Mesh& mesh, const Ball& ball, const ViewSphere& sphere, const RenderOptions& options,
                   const Draw& draw) {
  const ViewRenderer renderer(mesh, ball, options);
  tbb::enumerable_thread_specific<ViewRenderer> renderers(renderer);
  std::vector<std::size_t> halves;
  for (std::size_t k = 0; k < sphere.size(); ++k)
    if (k < sphere.opposite()[k]) halves.push_back(k);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, halves.size(), 1), [&](const auto& range) {
    ViewRenderer& own = renderers.local();
    for (std::size_t i = range.begin(); i < range.end(); ++i) draw(own, halves[i]);
  });
}

}  // namespace

void visit_views(const Mesh& mesh, const Ball& ball, const ViewSphere& sphere, const RenderOptions& options,
                 const Rotation& pose, const std::function<void(std::size_t, const DepthImage&)>& visit) {
  tbb::enumerable_thread_specific<std::pair<DepthImage, DepthImage>> buffers;
  for_each_pair(mesh, ball, sphere, options, [&](ViewRenderer& renderer, std::size_t k) {
    // Taken out for the time of the visit: if it waits for a parallel loop, this thread may begin another direction.
    std::pair<DepthImage, DepthImage> images = std::move(buffers.local());
    renderer.render_both(frame_towards(sphere.directions()[k], options.up) * pose, images.first, images.second);
    visit(k, images.first);
    visit(sphere.opposite()[k], images.second);
    buffers.local() = std::move(images);
  });
}

std::vector<DepthImage> render_views(const Mesh& mesh, const Ball& ball, const ViewSphere& sphere,
                                     const RenderOptions& options, const Rotation& pose) {
  std::vector<DepthImage> images(sphere.size());
  for_each_pair(mesh, ball, sphere, options, [&](ViewRenderer& renderer, std::size_t k) {
    renderer.render_both(frame_towards(sphere.directions()[k], options.up) * pose, images[k],
                         images[sphere.opposite()[k]]);
  });
  return images;
}

}  // namespace rectilin::render
