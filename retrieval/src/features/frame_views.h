// The pictures of a model in its frame that rich descriptors look at.
#pragma once

#include <functional>

#include "rectilin/render/rasterizer.h"
#include "rectilin/render/view_sphere.h"

namespace rectilin::retrieval {

/// Pictures of 256 x 256 pixels of a posed mesh, which is within the unit ball, from the directions of a sphere, each
/// with its number there; opposite ones one after the other.
inline void visit_frame_views(const Mesh& mesh, const render::ViewSphere& sphere,
                              const std::function<void(std::size_t, const render::DepthImage&)>& visit) {
  render::ViewRenderer renderer(mesh, render::Ball{Vector3::Zero(), 1}, {.size = 256});
  for (std::size_t k = 0; k < sphere.size(); ++k) {
    const std::size_t opposite = sphere.opposite()[k];
    if (opposite < k) continue;
    const auto [front, back] = renderer.render_both(render::frame_towards(sphere.directions()[k]));
    visit(k, front);
    visit(opposite, back);
  }
}

}  // namespace rectilin::retrieval
