// The 47 numbers that stand for a picture: 35 Zernike moments, 10 Fourier coefficients, eccentricity, compactness.
#pragma once

#include <array>

#include "rectilin/base/parameters.h"
#include "rectilin/render/rasterizer.h"

namespace rectilin::retrieval {

inline constexpr int kZernike = 35, kFourier = 10;
inline constexpr std::size_t kViewNumbers = kZernike + kFourier + 2;
using ViewNumbers = std::array<float, kViewNumbers>;

/// What the paper leaves open about them; the defaults are what did best on the training half of the Princeton Shape
/// Benchmark (papers/retrieval.md has each one's worth).
struct ViewFeatureOptions {
  enum class Image { kSilhouette, kDepth };
  enum class Centre { kCentroid, kPicture };
  enum class Eccentricity { kRoot, kSquared };
  enum class Contour { kLargest, kPolar };
  Image image = Image::kDepth;
  Centre centre = Centre::kCentroid;
  bool divide = false;
  Eccentricity eccentricity = Eccentricity::kRoot;
  Contour contour = Contour::kLargest;

  void bind(Parameters& parameters);
};

/// The numbers of a picture, each within [0, 1] or a little above. They do not change if the picture is reflected
/// or turned by right angles, and hardly if it is turned otherwise. An empty picture has zeros.
///     0-34   |A_nm|, n = 1 ... 10, of the silhouette or of the depths (0 background, 1 the near end of the range)
///     35-44  |C_k| / |C_0|, k = 1 ... 10, of the distances of the silhouette's outline from its centroid
///     45     eccentricity from second moments of the picture
///     46     compactness 4 pi A / p^2 of the silhouette, at most 1
ViewNumbers view_numbers(const render::DepthImage& image, const ViewFeatureOptions& options);

}  // namespace rectilin::retrieval
