#include "descriptors/extents.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "features/radial_extent.h"
#include "features/spherical_harmonics.h"
#include "matching/byte_distance.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

constexpr int kGrid = 64, kBandwidth = 16;
constexpr std::size_t kPole = 144;  // bytes of a polar axis: 136 magnitudes and zeros

struct ExtentsOptions {
  std::string pose = "rectilinear";
  void bind(Parameters& parameters) { bind_pose(parameters, pose); }
};

/// The paper's SHD (section 7.2) with square roots of the magnitudes as bytes: small ones tell shapes apart, too, and
/// bytes are compared many at a time.
class Extents final : public Descriptor {
 public:
  explicit Extents(ExtentsOptions options) : options_(std::move(options)), transform_(kGrid, kBandwidth) {}

  Signature describe(const Model& model) const override {
    const Mesh& mesh = model.posed(options_.pose);
    Signature signature(bytes());
    for (int pole = 0; pole < 3; ++pole) {
      const std::vector<double> magnitudes = transform_.magnitudes(radial_extent(mesh, kGrid, pole));
      double sum = 0;
      for (const double x : magnitudes) sum += x;
      if (!(sum > 0)) continue;
      for (std::size_t i = 0; i < magnitudes.size(); ++i)  // the largest is about a half of all
        signature[static_cast<std::size_t>(pole) * kPole + i] =
            static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, std::sqrt(2 * magnitudes[i] / sum))));
    }
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    std::array<std::uint32_t, 9> d;
    row_distances(a.data(), 3, b.data(), 3, kPole, d.data());
    const std::uint32_t least = std::min({d[0] + d[4] + d[8], d[0] + d[5] + d[7], d[1] + d[3] + d[8],
                                          d[1] + d[5] + d[6], d[2] + d[3] + d[7], d[2] + d[4] + d[6]});
    return least / (255.0 * static_cast<double>(3 * transform_.size()));
  }

  double typical_distance() const override { return 0.047; }
  std::size_t bytes() const override { return 3 * kPole; }
  std::string distance_in_words() const override { return "mean difference of a number, least of six orders"; }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position; reflection"; }

 private:
  ExtentsOptions options_;
  HarmonicTransform transform_;
};

}  // namespace

void add_extents(DescriptorFactory& factory) {
  factory.add("extents", "spherical harmonics of the surface's extent about three axes, in bytes", ExtentsOptions(),
              [](ExtentsOptions o) { return std::make_shared<Extents>(std::move(o)); });
}

}  // namespace rectilin::retrieval
