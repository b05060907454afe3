#include "descriptors/words.h"

#include <algorithm>
#include <cmath>

#include "features/code_book.h"
#include "features/frame_views.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

struct WordsOptions {
  std::string pose = "rectilinear";
  void bind(Parameters& parameters) { bind_pose(parameters, pose); }
};

/// Numbers of a unit vector are rarely above a half; these become bytes about 128.
constexpr double kStretch = 254;

class Words final : public Descriptor {
 public:
  explicit Words(WordsOptions options) : options_(std::move(options)), book_(CodeBook::built_in()), sphere_(1) {}

  Signature describe(const Model& model) const override {
    Residuals residuals(book_);
    visit_frame_views(model.posed(options_.pose), sphere_, [&](std::size_t, const render::DepthImage& image) {
      visit_local_features(image, Turn::kQuarter, [&](const LocalFeature& f) { residuals.add(f); });
    });
    Signature signature;
    for (const float x : project(book_, residuals.finished()))
      signature.push_back(
          static_cast<std::uint8_t>(128 + std::clamp(std::lround(kStretch * static_cast<double>(x)), -128l, 127l)));
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const int difference = a[i] - b[i];
      sum += static_cast<std::uint32_t>(difference * difference);
    }
    return std::min(1.0, std::sqrt(static_cast<double>(sum)) / (2 * kStretch));
  }

  double typical_distance() const override { return 0.705; }
  std::size_t bytes() const override { return static_cast<std::size_t>(book_.numbers); }
  std::string distance_in_words() const override { return "half the Euclidean distance of unit vectors"; }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position"; }

 private:
  WordsOptions options_;
  const CodeBook& book_;
  render::ViewSphere sphere_;
};

}  // namespace

void add_words(DescriptorFactory& factory) {
  factory.add("words", "local features of 18 depth pictures, by a vocabulary learned without labels", WordsOptions(),
              [](WordsOptions o) { return std::make_shared<Words>(std::move(o)); });
}

}  // namespace rectilin::retrieval
