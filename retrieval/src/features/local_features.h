// Local features of depth pictures: histograms of gradients on a dense grid, at several scales.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "rectilin/render/rasterizer.h"

namespace rectilin::retrieval {

/// SIFT's numbers (Lowe 2004, section 6): 4 x 4 cells of 8 directions.
inline constexpr int kLocal = 128;
using LocalFeature = std::array<float, kLocal>;

enum class Turn {
  kNone,     ///< as the picture lies
  kQuarter,  ///< turned by right angles until the gradients' main direction lies within [0, 90) degrees
  kFree,     ///< turned so that their main direction is up
};

/// Calls `take` for every patch that lies on the picture's shape: on a grid of step 4 in the picture at half, a quarter
/// and an eighth of its size, patches of 16 x 16 pixels each. Gradients are cut off at a height that steps between
/// surfaces share with slopes of 45 degrees and more. The features have unit length after their square roots are taken
/// (Arandjelovic and Zisserman 2012), so that their squared distance is twice one less the Hellinger affinity.
void visit_local_features(const render::DepthImage& image, Turn turn,
                          const std::function<void(const LocalFeature&)>& take);

}  // namespace rectilin::retrieval
