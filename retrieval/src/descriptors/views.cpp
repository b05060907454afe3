#include "descriptors/views.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "features/frame_views.h"
#include "features/rich_view.h"
#include "matching/byte_distance.h"
#include "rectilin/retrieval/bounded.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

/// Factors of the square roots of each block's numbers, in the order of kRichBlocks. Found on the training half of the
/// Princeton Shape Benchmark (papers/search.md), together with `words`.
constexpr std::array<double, kRichBlocks.size()> kBlockFactors{0.34, 0.55, 1, 0.4, 0.31, 0.1, 0.59, 1, 0.41, 0.23};

struct ViewsOptions {
  std::string pose = "rectilinear";
  std::array<double, kRichBlocks.size()> factors = kBlockFactors;

  void bind(Parameters& parameters) {
    bind_pose(parameters, pose);
    for (std::size_t k = 0; k < kRichBlocks.size(); ++k)
      parameters.real(kRichBlocks[k].name, factors[k], 0, 4, std::string("factor of the ") + kRichBlocks[k].help);
  }
};

/// Pictures from 18 directions, each described by 144 bytes; the least distance over the frame's 24 rotations. Each
/// picture's bytes are three rows of byte_distance.h.
class Views final : public Descriptor, public Bounded {
 public:
  explicit Views(ViewsOptions options) : options_(std::move(options)), sphere_(1) {
    static_assert(kRichNumbers == 3 * kRow);
    for (const auto& permutation : sphere_.permutations())
      for (const std::uint32_t k : permutation)
        for (std::uint32_t row = 0; row < 3; ++row) permutations_.push_back(static_cast<std::uint16_t>(3 * k + row));
  }

  Signature describe(const Model& model) const override {
    Signature signature(bytes());
    visit_frame_views(model.posed(options_.pose), sphere_, [&](std::size_t k, const render::DepthImage& image) {
      const RichNumbers numbers = rich_view_numbers(image);
      for (std::size_t b = 0; b < kRichBlocks.size(); ++b)
        for (int i = kRichBlocks[b].begin; i < kRichBlocks[b].begin + kRichBlocks[b].count; ++i) {
          const double x = std::sqrt(std::max(0.0, static_cast<double>(numbers[static_cast<std::size_t>(i)])));
          signature[k * kRichNumbers + static_cast<std::size_t>(i)] =
              static_cast<std::uint8_t>(std::lround(std::min(255.0, 255 * options_.factors[b] * std::min(1.0, x))));
        }
    });
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    return scaled(least_distance(a.data(), b.data(), 3 * sphere_.size(), permutations_));
  }
  double typical_distance() const override { return 0.048; }
  std::size_t bytes() const override { return kRichNumbers * sphere_.size(); }
  std::string distance_in_words() const override { return "mean difference of a number, least over 24 rotations"; }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position"; }

  // Rotations take the six pictures along the axes to each other, and the other twelve. Sums over these are the same
  // for all 24, and the difference of two sums is at most the sum of differences.
  std::size_t coarse_bytes() const override { return 2 * 2 * kRichNumbers; }
  Signature coarse(SignatureView signature) const override {
    std::array<std::uint16_t, 2 * kRichNumbers> sums{};
    for (std::size_t k = 0; k < sphere_.size(); ++k)
      for (std::size_t i = 0; i < kRichNumbers; ++i)
        sums[(k < 6 ? 0 : kRichNumbers) + i] =
            static_cast<std::uint16_t>(sums[(k < 6 ? 0 : kRichNumbers) + i] + signature[k * kRichNumbers + i]);
    Signature bytes(sizeof sums);
    std::memcpy(bytes.data(), sums.data(), sizeof sums);
    return bytes;
  }
  double bound(SignatureView a, SignatureView b) const override {
    std::array<std::uint16_t, 2 * kRichNumbers> x, y;
    std::memcpy(x.data(), a.data(), sizeof x);
    std::memcpy(y.data(), b.data(), sizeof y);
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += static_cast<std::uint32_t>(std::max(x[i], y[i]) - std::min(x[i], y[i]));
    return scaled(sum);
  }

 private:
  double scaled(std::uint32_t sum) const {
    return static_cast<double>(sum) / (255.0 * static_cast<double>(kRichNumbers * sphere_.size()));
  }

  ViewsOptions options_;
  render::ViewSphere sphere_;
  std::vector<std::uint16_t> permutations_;
};

}  // namespace

void add_views(DescriptorFactory& factory) {
  factory.add("views", "18 depth pictures: outline, slopes, directions, bends, depths; 144 bytes each", ViewsOptions(),
              [](ViewsOptions o) { return std::make_shared<Views>(std::move(o)); });
}

}  // namespace rectilin::retrieval
