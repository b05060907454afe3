#include "features/view_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/contour.h"
#include "features/fourier.h"
#include "features/zernike.h"

namespace rectilin::retrieval {
namespace {

using Options = ViewFeatureOptions;

/// Second moments about the mean, of pixels weighted by a picture.
struct Spread {
  double mass = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// `weight(column, row)` over the box of the picture.
Spread spread_of(const Picture& picture) {
  Spread s;
  for (Eigen::Index row = 0; row < picture.rows(); ++row) {
    double mass = 0, x = 0, xx = 0;
    const float* values = picture.data() + row * picture.cols();
    for (Eigen::Index column = 0; column < picture.cols(); ++column) {
      const double v = static_cast<double>(values[column]), c = static_cast<double>(column);
      mass += v;
      x += v * c;
      xx += v * c * c;
    }
    const double r = static_cast<double>(row);
    s.mass += mass;
    s.x += x;
    s.xx += xx;
    s.y += mass * r;
    s.xy += x * r;
    s.yy += mass * r * r;
  }
  s.x /= s.mass;
  s.y /= s.mass;
  s.xx = s.xx / s.mass - s.x * s.x;
  s.xy = s.xy / s.mass - s.x * s.y;
  s.yy = s.yy / s.mass - s.y * s.y;
  return s;
}

double eccentricity(const Spread& s, Options::Eccentricity kind) {
  const double sum = s.xx + s.yy, difference = std::hypot(s.xx - s.yy, 2 * s.xy);
  if (!(sum > 0)) return 0;
  if (kind == Options::Eccentricity::kSquared) return difference * difference / (sum * sum);
  return std::sqrt(std::max(0.0, (sum - difference) / (sum + difference)));
}

/// The farthest covered pixel in each of so many directions from a centre: an outline that parts and holes do not
/// break.
std::vector<double> polar_outline(std::span<const Pixel> boundary, double x, double y) {
  constexpr std::size_t kDirections = 128;
  std::vector<double> farthest(kDirections);
  for (const Pixel& p : boundary) {
    const double angle = std::atan2(p.y - y, p.x - x) / (2 * std::numbers::pi) + 0.5;
    const auto at = std::min(kDirections - 1, static_cast<std::size_t>(angle * kDirections));
    farthest[at] = std::max(farthest[at], std::hypot(p.x - x, p.y - y));
  }
  return farthest;
}

}  // namespace

void ViewFeatureOptions::bind(Parameters& parameters) {
  parameters
      .choice("image", image, {{"silhouette", Image::kSilhouette}, {"depth", Image::kDepth}},
              "what Zernike moments and eccentricity are of")
      .choice("centre", centre, {{"centroid", Centre::kCentroid}, {"picture", Centre::kPicture}},
              "of the disk of the moments: the silhouette's centroid with its farthest pixel as radius, or the "
              "picture's own")
      .flag("divide", divide, "divide the moments by A_00")
      .choice("eccentricity", eccentricity, {{"root", Eccentricity::kRoot}, {"squared", Eccentricity::kSquared}},
              "square root of the ratio of the principal second moments, or the squared form of the LFD's code")
      .choice("contour", contour, {{"largest", Contour::kLargest}, {"polar", Contour::kPolar}},
              "outline of the largest part, or the farthest pixel in each of 128 directions");
}

ViewNumbers view_numbers(const render::DepthImage& image, const ViewFeatureOptions& options) {
  ViewNumbers numbers{};
  const int size = image.size;
  int left = size, right = -1, top = size, bottom = -1;
  Mask mask(size);
  for (int y = 0; y < size; ++y) {
    const std::uint16_t* row = image.depth.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(size);
    std::uint8_t* out = mask.pixels.data() + mask.at(0, y);
    for (int x = 0; x < size; ++x) out[x] = row[x] != 0;
    int first = 0, last = size - 1;
    while (first < size && out[first] == 0) ++first;
    if (first == size) continue;
    while (out[last] == 0) --last;
    left = std::min(left, first);
    right = std::max(right, last);
    top = std::min(top, y);
    bottom = y;
  }
  if (right < 0) return numbers;

  Picture silhouette(bottom - top + 1, right - left + 1), picture;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) silhouette(y - top, x - left) = mask.pixels[mask.at(x, y)];
  if (options.image == Options::Image::kDepth) {
    picture.resize(silhouette.rows(), silhouette.cols());
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x)
        picture(y - top, x - left) = static_cast<float>(image.at(x, y)) * (1 / 65535.f);
  }
  const Picture& shown = options.image == Options::Image::kDepth ? picture : silhouette;
  const Spread outline = spread_of(silhouette);
  const Spread spread = options.image == Options::Image::kDepth ? spread_of(picture) : outline;

  const std::vector<Pixel> contour = outer_contour(mask);
  Disk disk{outline.x, outline.y, 0};
  if (options.centre == Options::Centre::kCentroid) {
    double farthest = 0;
    for (Eigen::Index row = 0; row < silhouette.rows(); ++row) {
      const float* values = silhouette.data() + row * silhouette.cols();
      Eigen::Index first = 0, last = silhouette.cols() - 1;
      while (first <= last && values[first] == 0) ++first;
      if (first > last) continue;
      while (values[last] == 0) --last;
      const double dy = static_cast<double>(row) - disk.y;
      for (const Eigen::Index column : {first, last}) {
        const double dx = static_cast<double>(column) - disk.x;
        farthest = std::max(farthest, dx * dx + dy * dy);
      }
    }
    disk.radius = std::sqrt(farthest) + 0.5;  // to the pixel's border
  } else {
    disk = {(size - 1) / 2.0 - left, (size - 1) / 2.0 - top, size / 2.0};
  }
  const auto moments = ZernikeMoments::instance()(shown, disk);
  const double unit = options.divide && std::abs(moments[0]) > 0 ? std::abs(moments[0]) : 1;
  std::size_t at = 0;
  for (std::size_t k = 1; k < moments.size(); ++k) numbers[at++] = static_cast<float>(std::abs(moments[k]) / unit);

  const double centre_x = outline.x + left, centre_y = outline.y + top;
  const std::vector<double> distances = options.contour == Options::Contour::kLargest
                                            ? centroid_distances(contour, centre_x, centre_y)
                                            : polar_outline(contour, centre_x, centre_y);
  for (const double c : fourier_descriptors(distances, kFourier)) numbers[at++] = static_cast<float>(c);
  numbers[at++] = static_cast<float>(eccentricity(spread, options.eccentricity));
  const double perimeter = static_cast<double>(boundary_pixels(mask));
  numbers[at] = static_cast<float>(std::min(1.0, 4 * std::numbers::pi * outline.mass / (perimeter * perimeter)));
  return numbers;
}

}  // namespace rectilin::retrieval
