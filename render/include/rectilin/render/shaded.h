// Meshes as a person likes to see them: shaded, with creases and outlines.
#pragma once

#include <cstdint>
#include <vector>

#include "rectilin/render/camera.h"

namespace rectilin::render {

/// A square picture of the ball, `size` values a row from the top: white background, faces grey by their slope against
/// a light from above, creases of 40 degrees and more and outlines drawn as lines. Orientation does not matter. Nine
/// samples a pixel, by the rasterizer of depth pictures and its rule Coverage::kCentre. Any soup will do that lies
/// within the ball sideways; what is further than ViewRenderer::kReach radii is refused, as is a size out of 1 to
/// kLargestPicture / 3 (std::invalid_argument).
std::vector<std::uint8_t> shaded(const Mesh& mesh, const Ball& ball, const Rotation& frame, int size);

/// The ball for which the mesh, seen in this frame, is as large in the picture as fits with a margin: a share of the
/// picture on each side, 0 to below 0.5. Its centre is in the middle of depths.
Ball ball_fitting(const Mesh& mesh, const Rotation& frame, double margin);

}  // namespace rectilin::render
