#include "descriptors/dla.h"

#include <vector>

#include "features/depth_lines.h"
#include "rectilin/render/view_sphere.h"
#include "rectilin/retrieval/poses.h"

namespace rectilin::retrieval {
namespace {

struct DlaOptions {
  std::string pose = "pca-definite";
  int size = 32, gap = 1, band = 3;

  void bind(Parameters& parameters) {
    bind_pose(parameters, pose);
    parameters.integer("size", size, 4, 256, "pixels in a row of a picture")
        .integer("gap", gap, 1, 4, "cost of leaving a state out or putting one in; changing one costs 1 or 2")
        .integer("band", band, 0, 256, "places by which a state may move");
  }
};

class Dla final : public Descriptor {
 public:
  explicit Dla(DlaOptions options) : options_(std::move(options)) {}

  Signature describe(const Model& model) const override {
    const render::ViewSphere sphere(0);
    render::ViewRenderer renderer(model.posed(options_.pose), render::Ball{Vector3::Zero(), 1},
                                  {.size = options_.size, .coverage = render::Coverage::kTouched});
    Signature signature;
    for (const Vector3& direction : sphere.directions()) {
      const std::vector<LineState> states = depth_lines(renderer.render(render::frame_towards(direction)));
      for (std::size_t i = 0; i < states.size(); i += 2)  // two to a byte; there is an even number of them
        signature.push_back(
            static_cast<std::uint8_t>(static_cast<int>(states[i]) | static_cast<int>(states[i + 1]) << 4));
    }
    return signature;
  }

  double distance(SignatureView a, SignatureView b) const override {
    const std::vector<LineState> x = states_of(a), y = states_of(b);
    const auto n = static_cast<std::size_t>(options_.size);
    long sum = 0;
    for (std::size_t i = 0; i < x.size(); i += n)
      sum += line_distance(std::span(x).subspan(i, n), std::span(y).subspan(i, n), options_.gap, options_.band);
    return static_cast<double>(sum) / (2 * static_cast<double>(x.size()));
  }

  double typical_distance() const override { return 0.2; }
  std::size_t bytes() const override {
    return 6 * static_cast<std::size_t>(options_.size) * static_cast<std::size_t>(options_.size);
  }
  std::string distance_in_words() const override { return "mean cost of a state over 2, of lines made equal"; }
  std::string invariant_to() const override { return "as the pose: rotation, scale, position"; }

 private:
  static std::vector<LineState> states_of(SignatureView s) {
    std::vector<LineState> states;
    states.reserve(2 * s.size());
    for (const std::uint8_t byte : s) {
      states.push_back(static_cast<LineState>(byte & 15));
      states.push_back(static_cast<LineState>(byte >> 4));
    }
    return states;
  }

  DlaOptions options_;
};

}  // namespace

void add_dla(DescriptorFactory& factory) {
  factory.add("dla", "depth lines along the principal axes, matched by dynamic programming (Chaouch et al. 2007)",
              DlaOptions(), [](DlaOptions o) { return std::make_shared<Dla>(std::move(o)); });
}

}  // namespace rectilin::retrieval
