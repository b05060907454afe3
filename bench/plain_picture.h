// The picture that the rasterizer is measured against.
#pragma once

#include "rectilin/render/rasterizer.h"

namespace rectilin::bench {

/// What anybody would write: barycentric coordinates of every pixel in a triangle's box, `size` pixels along an edge.
render::DepthImage plain_picture(const Mesh& mesh, const render::Ball& ball, const Rotation& frame, int size);

}  // namespace rectilin::bench
