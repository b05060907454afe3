// Depth pictures and silhouettes of meshes, in parallel projection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "rectilin/render/camera.h"
#include "rectilin/render/view_sphere.h"

namespace rectilin::render {

/// A square picture of depths, rows from the top. 0 is background; 1 to 65535 is the range of the ball from its far end
/// to its near end, in equal steps: a greater value is nearer to the viewer, and the middle plane is 32768.
struct DepthImage {
  int size = 0;                      ///< pixels in a row, and rows
  std::vector<std::uint16_t> depth;  ///< size * size values

  std::uint16_t at(int x, int y) const {
    return depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)];
  }
  /// The silhouette: whether something is seen there.
  bool covered(int x, int y) const { return at(x, y) != 0; }
  std::size_t covered_pixels() const;
};

/// Which pixels a triangle covers, after its corners were rounded to 1/256 of a pixel.
enum class Coverage {
  /// Those whose centre lies in the triangle or on its border. The share of covered pixels tends to the area; parts
  /// thinner than a pixel may be missed, and a triangle seen edge on is.
  kCentre,
  /// Those whose square (closed) the triangle touches: nothing is missed, not even what is seen edge on or is a point,
  /// and the silhouette is up to a pixel larger. A depth is that of the triangle's plane at the pixel's centre, kept
  /// within the depths of its corners.
  kTouched,
};

struct RenderOptions {
  int size = 256;  ///< pixels in a row: 1 to kLargestPicture
  Coverage coverage = Coverage::kCentre;
  Vector3 up = Vector3::UnitY();  ///< of the posed mesh, for pictures from a sphere: see frame_towards()
};

constexpr int kLargestPicture = 16384;

/// Draws one mesh from many directions. Everything behind the projection is done in whole numbers but for depths, which
/// need only sums and products of single precision that are rounded one by one: the same picture, bit for bit, whatever
/// the instruction set. Triangles are drawn on both sides, and the nearest is seen; their order does not matter.
///
/// The picture from the opposite direction is, by the rules above and frame_towards(), the same as that from behind
/// reflected left to right: `render_both` gives both for little more than the price of one.
///
/// Any soup of triangles will do, of coordinates of any size. What reaches out of the ball is cut off at the picture's
/// border, and in depth pressed to its ends; a mesh that reaches more than kReach radii from the centre is refused with
/// std::invalid_argument, and so are sizes out of range. One renderer must not be used by several threads at once; it
/// keeps a copy of the corners, and no reference to the mesh.
class ViewRenderer {
 public:
  static constexpr double kReach = 64;

  ViewRenderer(const Mesh& mesh, const Ball& ball, const RenderOptions& options = {});

  /// The frame's rows are the picture's right, its up and the direction to the viewer.
  DepthImage render(const Rotation& frame);

  /// The picture of `render`, and the one from behind: right and direction turned around, up kept.
  std::pair<DepthImage, DepthImage> render_both(const Rotation& frame);
  /// The same into pictures whose memory is used again.
  void render_both(const Rotation& frame, DepthImage& front, DepthImage& back);

  const RenderOptions& options() const { return options_; }

 private:
  struct Corner {
    std::int32_t x, y;  ///< in 1/256 of a pixel from the picture's centre, y down
    float z;            ///< towards the viewer, in steps of depth from the middle plane
  };

  void project(const Rotation& frame);
  template <bool kBoth>
  void draw();
  template <bool kBoth, Coverage kRule>
  void draw_all();
  void copy(const std::vector<std::int16_t>& plane, bool mirrored, DepthImage& image) const;

  RenderOptions options_;
  std::vector<double> points_;  ///< x of all vertices in use, then y, then z: from the centre, in radii
  std::vector<Triangle> triangles_;
  std::vector<Corner> corners_;
  std::vector<std::int16_t> front_, back_;  ///< least value: background
};

/// The pictures of a posed mesh from all directions of a sphere, in their order. The pose turns the mesh about the
/// ball's centre first; each picture's frame is frame_towards(direction, options.up). Runs on all of TBB's threads,
/// with the same bits for any number of them. Errors as ViewRenderer.
std::vector<DepthImage> render_views(const Mesh& mesh, const Ball& ball, const ViewSphere& sphere,
                                     const RenderOptions& options = {}, const Rotation& pose = {});

/// Without keeping them: `visit(k, image)` is called once for each direction k, from any thread, several at a time; the
/// image is gone afterwards.
void visit_views(const Mesh& mesh, const Ball& ball, const ViewSphere& sphere, const RenderOptions& options,
                 const Rotation& pose, const std::function<void(std::size_t, const DepthImage&)>& visit);

}  // namespace rectilin::render
