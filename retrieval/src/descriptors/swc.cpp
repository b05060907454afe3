#include "descriptors/swc.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "features/radial_extent.h"
#include "features/spherical_wavelets.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

struct SwcOptions {
  std::string pose = "rectilinear";
  int samples = 4, kept = 3;
  bool all = true;

  void bind(Parameters& parameters) {
    bind_pose(parameters, pose);
    parameters
        .integer("samples", samples, 0, 6, "level of the sphere on which the extent is sampled: 6 to 16386 points")
        .integer("kept", kept, 0, 6, "level up to which coefficients are kept, at most that of the samples")
        .choice("match", all, {{"all", true}, {"one", false}}, "rotations of one model's frame that are tried");
  }
};

/// Numbers of 16 bits, so that the sum of squares is exact and does not depend on the order of a permutation.
class Swc final : public Descriptor {
 public:
  explicit Swc(SwcOptions options)
      : options_(std::move(options)),
        sphere_(options_.samples),
        wavelets_(sphere_),
        kept_(static_cast<std::size_t>(std::min(options_.kept, options_.samples))) {
    const render::ViewSphere coarse(static_cast<int>(kept_));
    for (std::size_t i = 0; i < coarse.permutations().size(); ++i) {
      const bool identity = frame_symmetries()[i].matrix().trace() > 2.5;
      if (options_.all || identity) permutations_.push_back(coarse.permutations()[i]);
    }
    count_ = coarse.size();
  }

  Signature describe(const Model& model) const override {
    const std::vector<double> all =
        wavelets_.coefficients(radial_extent(model.posed(options_.pose), sphere_.directions()));
    double sum = 0;
    for (std::size_t k = 0; k < count_; ++k) sum += std::abs(all[k]);
    if (!(sum > 0)) throw MeshError("no direction from its centre meets its surface");
    Signature signature(bytes());
    for (std::size_t k = 0; k < count_; ++k) {
      const auto number = static_cast<std::int16_t>(std::lround(kOne * all[k] / sum));
      std::memcpy(signature.data() + 2 * k, &number, 2);
    }
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    const std::vector<std::int16_t> x = numbers(a), y = numbers(b);
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const auto& permutation : permutations_) {
      std::int64_t sum = 0;
      for (std::size_t k = 0; k < count_; ++k) {
        const std::int64_t difference = x[k] - y[permutation[k]];
        sum += difference * difference;
      }
      least = std::min(least, sum);
    }
    // Opposite vectors are at most 2 apart, and rounding may add a little.
    return std::min(1.0, std::sqrt(static_cast<double>(least)) / (2 * kOne));
  }

  double typical_distance() const override { return 0.08; }
  std::size_t bytes() const override { return 2 * count_; }
  std::string distance_in_words() const override {
    return "half the Euclidean distance of lists of L1 norm 1, least over the rotations tried";
  }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position"; }

 private:
  static constexpr double kOne = 32767;

  std::vector<std::int16_t> numbers(SignatureView s) const {
    std::vector<std::int16_t> result(count_);
    std::memcpy(result.data(), s.data(), 2 * count_);
    return result;
  }

  SwcOptions options_;
  render::ViewSphere sphere_;
  SphericalWavelets wavelets_;
  std::size_t kept_, count_ = 0;
  std::vector<std::vector<std::uint32_t>> permutations_;
};

}  // namespace

void add_swc(DescriptorFactory& factory) {
  factory.add("swc", "spherical wavelet coefficients of the surface's extent (Laga et al. 2006)", SwcOptions(),
              [](SwcOptions o) { return std::make_shared<Swc>(std::move(o)); });
}

}  // namespace rectilin::retrieval
