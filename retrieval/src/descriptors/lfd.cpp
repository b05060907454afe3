#include "descriptors/lfd.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "features/light_field.h"
#include "features/ntu_features.h"
#include "features/view_features.h"
#include "matching/byte_distance.h"
#include "rectilin/render/rasterizer.h"

namespace rectilin::retrieval {
namespace {

constexpr std::size_t kViews = kFields * kCameras;
constexpr std::size_t kFieldsPadded = 12;  // a multiple of the 4 sums in a register

/// Least over the 10 x 10 pairs of light fields and the 60 rotations of the sum over the cameras. Views are rows of
/// `row` bytes, a's in the order [field][camera], b's in the order [camera][field] with kFieldsPadded fields, so that
/// one rotation is tried on all fields of b at once.
std::uint32_t least_over_light_fields(const std::uint8_t* a, const std::uint8_t* b, std::size_t row) {
  std::array<std::uint32_t, kViews * kCameras * kFieldsPadded> distances;
  row_distances(a, kViews, b, kCameras * kFieldsPadded, row, distances.data());
  const auto& rotations = light_field_rotations();
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t f = 0; f < kFields; ++f) {
    const std::uint32_t* table = distances.data() + f * kCameras * kCameras * kFieldsPadded;
    for (const auto& rotation : rotations) {
      std::array<std::uint32_t, kFieldsPadded> sums{};
      for (std::size_t c = 0; c < kCameras; ++c) {
        const std::uint32_t* from = table + (c * kCameras + rotation[c]) * kFieldsPadded;
        for (std::size_t g = 0; g < kFieldsPadded; ++g) sums[g] += from[g];
      }
      least = std::min(least, *std::min_element(sums.begin(), sums.begin() + kFields));
    }
  }
  return least;
}

/// b's rows from the order [field][camera], by `write(view, row)`.
template <std::size_t kBytes, class Write>
auto camera_major(const Write& write) {
  std::array<std::uint8_t, kCameras * kFieldsPadded * kBytes> rows{};
  for (std::size_t f = 0; f < kFields; ++f)
    for (std::size_t c = 0; c < kCameras; ++c) write(f * kCameras + c, rows.data() + (c * kFieldsPadded + f) * kBytes);
  return rows;
}

/// The middle of the bounding box in the picture's middle, the longest side half as long as the picture.
render::Ball lfd_ball(const Mesh& mesh) {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t) {
      low = low.cwiseMin(mesh.vertices[v]);
      high = high.cwiseMax(mesh.vertices[v]);
    }
  return {(low + high) / 2, (high - low).maxCoeff()};
}

struct LfdOptions {
  int size = 256;
  void bind(Parameters& parameters) { parameters.integer("size", size, 16, 1024, "pixels in a row of a picture"); }
};

/// Section 7.1: the numbers of gsmd's silhouettes, from 10 light fields of 10 (opposite pairs of) views.
class PaperLfd final : public Descriptor {
 public:
  explicit PaperLfd(LfdOptions options) : options_(options) {
    features_.image = ViewFeatureOptions::Image::kSilhouette;
  }

  Signature describe(const Model& model) const override {
    const Mesh& mesh = model.posed("none");
    render::ViewRenderer renderer(mesh, {Vector3::Zero(), 1}, {.size = options_.size});
    Signature signature;
    for (const Vector3& direction : light_field_directions())
      append(signature, view_numbers(renderer.render(render::frame_towards(direction)), features_));
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    const auto rows = camera_major<kRow>(
        [&](std::size_t view, std::uint8_t* row) { std::copy_n(b.data() + view * kRow, kRow, row); });
    return least_over_light_fields(a.data(), rows.data(), kRow) / (255.0 * kViewNumbers * kCameras);
  }

  double typical_distance() const override { return 0.075; }
  std::size_t bytes() const override { return kViews * kRow; }
  std::string distance_in_words() const override {
    return "mean difference of a number, least of 10 x 10 light fields and 60 rotations";
  }
  std::string invariant_to() const override { return "position, scale, reflection; nearly rotation"; }

 private:
  static void append(Signature& signature, const ViewNumbers& numbers) {
    float sum = 0;
    for (const float x : numbers) sum += x;
    for (const float x : numbers) {
      const double share = sum > 0 ? static_cast<double>(x) * 6 / static_cast<double>(sum) : 0;
      signature.push_back(static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, share))));
    }
    signature.push_back(0);
  }

  LfdOptions options_;
  ViewFeatureOptions features_;
};

/// Chen, Tian, Shen and Ouhyoung 2003, as their program computes and stores it. The distance is theirs, L1 with the
/// weights ART 1, Fourier 2, circularity 2, eccentricity 1, over both models' own numbers.
class NtuLfd final : public Descriptor {
 public:
  static constexpr std::size_t kArt = 35, kFd = 10;
  static constexpr std::size_t kBytes = kViews * (kArt + kFd + 2);
  static constexpr std::size_t kWideRow = 64;  // what counts twice is there twice: 35 + 2 * 10 + 2 + 1 bytes

  explicit NtuLfd(LfdOptions options) : options_(options) {}

  Signature describe(const Model& model) const override {
    const Mesh& mesh = model.mesh();
    render::ViewRenderer renderer(mesh, lfd_ball(mesh), {.size = options_.size});
    Signature signature(kBytes);
    for (std::size_t f = 0; f < kFields; ++f) {
      std::vector<Mask> masks;
      for (std::size_t c = 0; c < kCameras; ++c) {
        const render::DepthImage image =
            renderer.render(render::frame_towards(light_field_directions()[f * kCameras + c]));
        masks.emplace_back(image.size);
        for (int y = 0; y < image.size; ++y)
          for (int x = 0; x < image.size; ++x) masks.back().pixels[masks.back().at(x, y)] = image.covered(x, y);
      }
      const auto views = ntu_features(std::span<const Mask, kCameras>(masks));
      for (std::size_t c = 0; c < kCameras; ++c) {
        const std::size_t k = f * kCameras + c;
        std::ranges::copy(views[c].art, signature.begin() + static_cast<std::ptrdiff_t>(k * kArt));
        std::ranges::copy(views[c].fd, signature.begin() + static_cast<std::ptrdiff_t>(kViews * kArt + k * kFd));
        signature[kViews * (kArt + kFd) + k] = views[c].cir;
        signature[kViews * (kArt + kFd + 1) + k] = views[c].ecc;
      }
    }
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    std::array<std::uint8_t, kViews * kWideRow> rows_a{};
    for (std::size_t k = 0; k < kViews; ++k) widen(a, k, rows_a.data() + k * kWideRow);
    const auto rows_b = camera_major<kWideRow>([&](std::size_t view, std::uint8_t* row) { widen(b, view, row); });
    return least_over_light_fields(rows_a.data(), rows_b.data(), kWideRow) / kLargest;
  }

  double typical_distance() const override { return 0.075; }
  std::size_t bytes() const override { return kBytes; }
  std::string distance_in_words() const override {
    return "the authors' weighted L1 over 147900, least of 10 x 10 light fields and 60 rotations";
  }
  std::string invariant_to() const override { return "position, reflection; nearly rotation"; }

 private:
  static constexpr double kLargest = 255.0 * (kArt + 2 * kFd + 3) * kCameras;

  static void widen(SignatureView s, std::size_t view, std::uint8_t* row) {
    row = std::copy_n(s.data() + view * kArt, kArt, row);
    row = std::copy_n(s.data() + kViews * kArt + view * kFd, kFd, row);
    row = std::copy_n(s.data() + kViews * kArt + view * kFd, kFd, row);
    *row++ = s[kViews * (kArt + kFd) + view];
    *row++ = s[kViews * (kArt + kFd) + view];
    *row++ = s[kViews * (kArt + kFd + 1) + view];
  }

  LfdOptions options_;
};

}  // namespace

void add_lfd(DescriptorFactory& factory) {
  factory.add("lfd", "light field descriptor with the paper's 47 numbers of each silhouette (section 7.1)",
              LfdOptions(), [](LfdOptions o) { return std::make_shared<PaperLfd>(o); });
  factory.add(
      "lfd:ntu",
      "light field descriptor as its authors' program has it: the bytes of .art, .fd, .cir and .ecc (Chen et al. "
      "2003)",
      LfdOptions(), [](LfdOptions o) { return std::make_shared<NtuLfd>(o); });
}

}  // namespace rectilin::retrieval
